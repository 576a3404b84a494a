"""The measurements of scripts/study.py: one surface each, and what several seeds and a search make of them."""

import csv
import math
from dataclasses import dataclass, fields
from statistics import fmean


@dataclass
class Result:
    """One surface against the truth. Distances are infinite where a method found nothing or failed: such a case is
    lost."""

    case: str
    noise: str
    bias_field: float
    seed: int
    method: str
    parameter: str = ""
    status: str = "done"
    assd_mm: float = math.inf
    hd95_mm: float = math.inf
    bias_mm: float = math.nan
    assd_voxels: float = math.inf
    hd95_voxels: float = math.inf
    bias_voxels: float = math.nan
    dice: float = math.nan
    volume_error: float = math.nan
    vertex_rms_voxels: float = math.nan
    moved_assd_voxels: float = math.nan  # from the same method's surface without noise
    moved_hd95_voxels: float = math.nan
    seconds: float = math.nan

    def take(self, metrics, voxel_mm):
        """The numbers of volsurf-compare; null stands for what an open surface has not."""

        def number(name):
            return math.nan if metrics[name] is None else metrics[name]

        for name in ("assd", "hd95", "bias"):
            setattr(self, f"{name}_mm", number(name))
            setattr(self, f"{name}_voxels", number(name) / voxel_mm)
        self.dice, self.volume_error = number("dice"), number("volume_error")

    @classmethod
    def from_row(cls, row):
        return cls(**{field.name: field.type(row[field.name]) for field in fields(cls)})

    @property
    def scan(self):
        return (self.case, self.noise, self.bias_field, self.seed)


def read_results(path):
    """Of a results.csv."""
    with open(path, encoding="utf-8", newline="") as file:
        return [Result.from_row(row) for row in csv.DictReader(file)]


@dataclass(frozen=True)
class Score:
    """A method on one case and noise: means over the seeds, each with the parameter that was best for it."""

    assd: float  # in voxels; infinite if a seed was lost
    hd95: float
    bias: float
    dice: float
    volume_error: float
    seconds: float
    parameters: tuple
    lost: int
    seeds: int
    worst_assd: float
    worst_hd95: float
    worst_vertex_rms: float
    worst_volume_error: float  # without its sign
    moved_assd: float
    moved_hd95: float


def best_of_each(results):
    """{(case, bias field, noise): {method: Score}}, in the order of the results."""
    runs = {}
    for result in results:
        place = runs.setdefault((result.case, result.bias_field, result.noise), {}).setdefault(result.method, {})
        best = place.get(result.seed)
        if best is None or result.assd_mm < best.assd_mm:
            place[result.seed] = result
    return {key: {method: score_of(list(seeds.values())) for method, seeds in found.items()}
            for key, found in runs.items()}


def score_of(results):
    """The mean over seeds, and the worst of them."""

    def mean(name):
        return fmean(getattr(result, name) for result in results)

    def worst(name):
        return max(abs(getattr(result, name)) for result in results)

    return Score(
        mean("assd_voxels"), mean("hd95_voxels"), mean("bias_voxels"), mean("dice"), mean("volume_error"),
        mean("seconds"), tuple(sorted({result.parameter for result in results if result.parameter})),
        sum(math.isinf(result.assd_mm) for result in results), len(results), worst("assd_voxels"), worst("hd95_voxels"),
        worst("vertex_rms_voxels"), worst("volume_error"), mean("moved_assd_voxels"), mean("moved_hd95_voxels"))
