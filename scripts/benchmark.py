#!/usr/bin/python3
"""Runs volsurf and what a user would use instead by turns, and writes docs/benchmarks.md.

In:  the build folder with the programs of tests/benchmark, and the folder with the volumes. scripts/benchmark.sh
     prepares both.
Out: the table, and BUILD/results.json with each single measurement. Each measurement is a process of its own, so that
     its peak memory is that program's.
"""

import argparse
import datetime
import json
import os
import re
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median

REPOSITORY = Path(__file__).resolve().parent.parent
ROUNDS = 5
SLOW_SECONDS = 20  # what takes longer is run less often
SLOW_ROUNDS = 3
MOST_BUSY = 0.05
CH2, SMALL_PHANTOM, LARGE_PHANTOM, HUGE_PHANTOM = "ch2 (MR head)", "phantom 256^3", "phantom 512^3", "phantom 1024^3"
STAGES = ("gradient and merge", "cut", "boundary", "components")
REPEATS = 3  # in one process, of what is fast
# Memory that a process frees remains its own, and so remains in the machine: what a virtual machine gives back to its
# host, which takes its time to find it again, comes and goes by chance.
TUNABLES = "glibc.malloc.mmap_max=0:glibc.malloc.trim_threshold=1099511627776"


@dataclass(frozen=True)
class Program:
    """One row of a table."""

    label: str
    words: tuple  # the program's name and its own arguments
    threads: int
    repeats: int = 1


def volsurf(threads, label="volsurf", words=()):
    return Program(label, ("volsurf_compute", *words), threads, REPEATS)


def peer(name, label, threads, repeats=1):
    return Program(label, ("peer_benchmark", name), threads, repeats)


def vtk_surface(threads):
    return peer("vtk_surface", "VTK gradient magnitude + FlyingEdges3D", threads, REPEATS)


def vtk_largest_surface(threads):
    return peer("vtk_largest_surface", "the same + PolyDataConnectivityFilter", threads, REPEATS)


def vtk_bare_surface(threads):
    return peer("vtk_surface_bare", "VTK gradient magnitude + FlyingEdges3D without normals", threads, REPEATS)


ITK_MORPHOLOGICAL = peer("itk_morphological_watershed", "ITK gradient magnitude + MorphologicalWatershed", 1)
ITK_MORPHOLOGICAL_26 = peer("itk_morphological_watershed_26", "the same, fully connected as volsurf is", 1)
ITK_WATERSHED = peer("itk_watershed", "ITK gradient magnitude + Watershed", 1)
PLAIN_KRUSKAL = peer("plain_kruskal", "plain Kruskal over all faces", 1)
GUDHI = peer("gudhi", "GUDHI cubical complex", 1)
VOLSURF = (volsurf(1), volsurf(2))
VOLSURF_WITH_MESH = volsurf(2, "volsurf with the triangles", ("--mesh",))
VTK_ON_TWO = (vtk_surface(2), vtk_largest_surface(2))
USUAL = (*VOLSURF, *VTK_ON_TWO, ITK_MORPHOLOGICAL)


@dataclass
class Case:
    """One volume and what is run on it."""

    name: str
    file: str
    options: tuple
    programs: tuple
    most_repeats: int = REPEATS
    runs: dict = field(default_factory=dict)  # per program, the JSON objects that it printed

    def command(self, program, quick):
        """The command line, without folders."""
        repeats = 1 if quick else min(program.repeats, self.most_repeats)
        counts = ("--threads", str(program.threads), "--repeat", str(repeats))
        return [*program.words, self.file, *self.options, *counts]


def all_cases(huge):
    ch2 = ("--delta", "5", "--iso", "60")
    phantom = ("--delta", "100", "--iso", "600")
    on_ch2 = (
        *VOLSURF, VOLSURF_WITH_MESH, vtk_surface(1), vtk_bare_surface(2), *VTK_ON_TWO, ITK_MORPHOLOGICAL,
        ITK_MORPHOLOGICAL_26, PLAIN_KRUSKAL,
    )
    cases = [
        Case(CH2, "ch2.nii.gz", ch2, on_ch2),
        Case("ch2, its middle 128^3", "ch2.nii.gz", (*ch2, "--crop", "128"), (*VOLSURF, PLAIN_KRUSKAL)),
        Case("ch2, its middle 64^3", "ch2.nii.gz", (*ch2, "--crop", "64"), (*VOLSURF, ITK_WATERSHED, GUDHI)),
        Case("cranium (CT head)", "cranium.nhdr", ("--delta", "100", "--iso", "300"), USUAL),
        Case("liver (labels)", "liver.nhdr", ("--delta", "20", "--iso", "60"), USUAL),
        Case(SMALL_PHANTOM, "phantom-256.nrrd", phantom, USUAL),
        Case(LARGE_PHANTOM, "phantom-512.nrrd", phantom, (*VOLSURF, *VTK_ON_TWO)),
    ]
    if huge:
        cases.append(Case(HUGE_PHANTOM, "phantom-512.nrrd", (*phantom, "--tile", "2"), (volsurf(2),), most_repeats=1))
    return cases


class Laboratory:
    """Where the programs and the volumes are."""

    def __init__(self, build, volumes):
        self.programs = build / "tests" / "benchmark"
        self.volumes = volumes

    def run(self, case, program, quick):
        words = case.command(program, quick)
        words = [self.programs / words[0], *words[1:]]
        words[words.index(case.file)] = self.volumes / case.file
        environment = {**os.environ, "GLIBC_TUNABLES": TUNABLES}
        done = subprocess.run(words, capture_output=True, text=True, check=False, env=environment)
        if done.returncode != 0:
            sys.exit(f"benchmark.py: {' '.join(map(str, words))}: exit code {done.returncode}: {done.stderr.strip()}")
        return json.loads(done.stdout)

    def measure(self, case, quick):
        """All programs by turns, so that a change of the machine's speed meets each of them."""
        case.runs = {program: [] for program in case.programs}
        for round_number in range(1 if quick else ROUNDS):
            for program, runs in case.runs.items():
                if round_number >= SLOW_ROUNDS and median(seconds(runs)) > SLOW_SECONDS:
                    continue
                runs.append(self.run(case, program, quick))
                print(f"{case.name}: {program.label}, on {program.threads}: {seconds(runs)[-1]:.3f} s", flush=True)


def seconds(runs):
    """Of each repeat of each run, all stages."""
    return [sum(stages.values()) for run in runs for stages in run["seconds"]]


def nanoseconds(runs):
    return [1e9 * time_s / runs[0]["samples"] for time_s in seconds(runs)]


def first_seconds(runs):
    """Of the first repeat of each run, which has to get its memory from the system."""
    return [sum(run["seconds"][0].values()) for run in runs]


def cpu_nanoseconds(runs):
    """Of all threads together; a busy machine changes them less."""
    return [1e9 * time_s / run["samples"] for run in runs for time_s in run["cpu_seconds"]]


def beyond_input(runs):
    """Bytes per sample."""
    return max(run["bytes_beyond_input"] for run in runs) / runs[0]["samples"]


def table(header, rows):
    """Markdown; the first column is text, the others are numbers."""
    lines = [header, ["---"] + ["---:"] * (len(header) - 1), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)


def case_table(case):
    own = {program.threads: median(seconds(runs)) for program, runs in case.runs.items() if program in VOLSURF}
    rows = []
    for program, runs in case.runs.items():
        times = nanoseconds(runs)
        rows.append([
            program.label,
            program.threads,
            f"{median(times):.1f}",
            f"{min(times):.1f} - {max(times):.1f}",
            f"{1e9 * median(first_seconds(runs)) / runs[0]['samples']:.1f}",
            f"{median(cpu_nanoseconds(runs)):.1f}",
            f"{median(seconds(runs)):.3f}",
            f"{median(seconds(runs)) / own[program.threads]:.2f}" if program.threads in own else "",
            f"{max(run['peak_bytes'] for run in runs) / 1e6:.0f}",
            f"{beyond_input(runs):.1f}",
            len(times),
        ])
    header = [
        "program", "threads", "ns per sample", "least - most", "first", "of processors", "s", "time / volsurf's",
        "peak MB", "bytes per sample beyond the input", "measured",
    ]
    return table(header, rows)


def case_title(case):
    first = next(iter(case.runs.values()))[0]
    size = " x ".join(map(str, first["size"]))
    return (
        f"### {case.name}\n\n{size}, {first['samples'] / 1e6:.1f} million samples, sigma {first['sigma_mm']:g} mm, "
        f"delta {first['delta']:g} per mm; volsurf finds {facts_text(first['facts'])}."
    )


def facts_text(facts):
    return (
        f"{facts['basins']:,} basins, {facts['regions']:,} regions, and a boundary of {facts['faces']:,} faces in "
        f"{facts['components']:,} parts"
    )


def stage_table(cases):
    """volsurf's stages, on two threads."""
    rows = []
    for case in cases:
        runs = case.runs.get(VOLSURF[1], [])
        for_stage = {}
        for run in runs:
            for stages in run["seconds"]:
                for stage, duration in stages.items():
                    for_stage.setdefault(stage, []).append(1e9 * duration / run["samples"])
        if for_stage:
            rows.append([case.name, *(f"{median(for_stage[stage]):.2f}" for stage in STAGES)])
    return table(["volume", *STAGES], rows)


def bar(what, limit, value, unit="", least=False):
    """A row of the table of bars."""
    limit_text = f"{'>=' if least else '<='} {limit}{unit}"
    if value is None:
        return [what, limit_text, "not measured", ""]
    met = value >= limit if least else value <= limit
    return [what, limit_text, f"{value:.3g}{unit}", "yes" if met else "no"]


def bars_table(cases):
    """What volsurf is to hold."""
    whole = {case.name: case for case in cases if "--crop" not in case.options}
    ch2 = {program: median(nanoseconds(runs)) for program, runs in whole[CH2].runs.items()}
    small, large = (whole[name].runs[VOLSURF[1]] for name in (SMALL_PHANTOM, LARGE_PHANTOM))
    huge = whole[HUGE_PHANTOM].runs[VOLSURF[1]] if HUGE_PHANTOM in whole else None
    one, two = (ch2[program] for program in VOLSURF)
    vtk, vtk_largest, itk = (ch2[program] for program in (*VTK_ON_TWO, ITK_MORPHOLOGICAL))
    growth = median(nanoseconds(large)) / median(nanoseconds(small))
    memory = max(beyond_input(case.runs[VOLSURF[1]]) for case in whole.values())
    rows = [
        bar("ns per sample, ch2, 1 thread", 25, one),
        bar("ns per sample, ch2, 2 threads", 14, two),
        bar("ITK gradient + MorphologicalWatershed / volsurf, ch2, 1 thread", 30, itk / one, least=True),
        bar("volsurf / VTK gradient + FlyingEdges3D, ch2, 2 threads", 1.5, two / vtk),
        bar("the same with PolyDataConnectivityFilter on VTK's side", 1, two / vtk_largest),
        bar("plain Kruskal / volsurf, ch2, 1 thread", 20, ch2[PLAIN_KRUSKAL] / one, least=True),
        bar("memory beyond the input, bytes per sample, the most of all volumes", 12, memory),
        bar("phantom 512^3, 2 threads", 2, median(seconds(large)), " s"),
        ["the same, the first time of each process", "", f"{median(first_seconds(large)):.3g} s", ""],
        bar("its time per sample / that of phantom 256^3", 1.5, growth),
        bar("phantom 1024^3, peak memory", 16, huge and max(run["peak_bytes"] for run in huge) / 1e9, " GB"),
    ]
    return table(["figure", "bar", "measured", "met"], rows)


def first_line(words):
    return subprocess.run(words, capture_output=True, text=True, check=False, cwd=REPOSITORY).stdout.split("\n")[0]


def compiler(build):
    cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
    return first_line([re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, re.MULTILINE).group(1), "--version"])


def machine():
    description = Path("/proc/cpuinfo").read_text(encoding="utf-8")

    def entry(name):
        found = re.search(rf"^{name}\s*: (.*)$", description, re.MULTILINE)
        return found.group(1) if found else f"unknown {name}"

    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 2**30
    return f"{entry('model name')}, {entry('cpu MHz')} MHz, {os.cpu_count()} cores, {memory:.0f} GiB"


def busy_share():
    """The part of the processors' time that other programs take now."""

    def ticks():
        words = Path("/proc/stat").read_text(encoding="utf-8").split("\n", 1)[0].split()[1:]
        return int(words[3]), sum(map(int, words[:8]))

    idle_before, all_before = ticks()
    time.sleep(2)
    idle, total = ticks()
    return 1 - (idle - idle_before) / (total - all_before)


def commands(cases, quick):
    lines = []
    for case in cases:
        lines += [" ".join(case.command(program, quick)) for program in case.programs]
    return "\n".join(lines)


TEXT = """# Benchmarks

Written by `scripts/benchmark.sh{words}`; run it again to measure anew.

{setting}

All times are of computing in memory: reading and writing are left out. volsurf's go from the gradient to the connected
components of the boundary. Programs run by turns, each as a process of its own; times are medians over all
measurements, of which there are
{rounds}.
A process computes up to {repeats} times and keeps the memory that it frees. The column "first" has the medians of the
first times, which get it from the system: on a virtual machine that may take as long as a stage. The column "of
processors" is the time of all threads together, in ns per sample. Memory is the peak of the process the first time;
beyond the input is what computing adds to what is there after reading: the samples as float32, and the libraries.

- VTK computes the gradient magnitude and, on the scan, an iso-surface: triangles with normals, as is its default. It
  runs on TBB where there are 2 threads; PolyDataConnectivityFilter has one. volsurf has no triangles yet at this
  point; `volsurf with the triangles` has.
- ITK's MorphologicalWatershed gets level = delta and labels every sample. By default its neighbours are those over
  faces; fully connected it finds as many regions as volsurf does, but for the difference of their gradients.
- Plain Kruskal (`tests/benchmark/plain_kruskal.h`) is the region merge as it is written down: std::sort of the faces,
  two union-finds, 32-bit ids, one thread. Each run compares its regions with volsurf's: they are the same, cell by
  cell.
- GUDHI computes the persistence of the same field. Each run compares the number of regions.

## Bars

{bars}

## Volumes

{volumes}

## Stages of volsurf

ns per sample on 2 threads, medians.

{stages}

## Commands

The programs are in the build folder's `tests/benchmark`, the volumes come from `scripts/fetch_data.sh` and
`volsurf-phantom --size N --noise impulse:2% --type uint16`. Each line was run {rounds_of_commands}.

```
export GLIBC_TUNABLES={tunables}
{commands}
```
"""


def rounds_text(quick):
    if quick:
        return "one of each, as this was a quick run to see whether all works"
    return f"at least {ROUNDS} of each program, {SLOW_ROUNDS} of what takes more than {SLOW_SECONDS} s"


def busy_text(busy):
    warning = ": too much, these figures are not to be trusted" if busy > MOST_BUSY else ""
    return f"at most {100 * busy:.0f} % before each volume{warning}"


def document(cases, arguments, started, busy):
    setting = table(["", ""], [
        ["date", started.strftime("%Y-%m-%d %H:%M UTC")],
        ["volsurf", first_line(["git", "describe", "--always", "--dirty"])],
        ["machine", machine()],
        ["compiler", compiler(arguments.build) + ", release build"],
        ["other programs' part of the processors", busy_text(busy)],
    ])
    return TEXT.format(
        words=" --quick" * arguments.quick + " --huge" * arguments.huge,
        setting=setting,
        rounds=rounds_text(arguments.quick),
        rounds_of_commands="once" if arguments.quick else f"{ROUNDS} times, the slow ones {SLOW_ROUNDS} times",
        bars=bars_table(cases),
        volumes="\n\n".join(f"{case_title(case)}\n\n{case_table(case)}" for case in cases),
        stages=stage_table(cases),
        commands=commands(cases, arguments.quick),
        repeats=REPEATS,
        tunables=TUNABLES,
    )


def parse(words):
    parser = argparse.ArgumentParser(description="Measures volsurf against its peers; see scripts/benchmark.sh.")
    parser.add_argument("build", type=Path, help="build folder with the programs")
    parser.add_argument("volumes", type=Path, help="folder with the volumes")
    parser.add_argument("--quick", action="store_true", help="one run of each")
    parser.add_argument("--huge", action="store_true", help="also 1024^3")
    parser.add_argument("--out", type=Path, default=REPOSITORY / "docs" / "benchmarks.md", help="the table")
    return parser.parse_args(words)


def main(words):
    arguments = parse(words)
    started, busy = datetime.datetime.now(datetime.timezone.utc), 0
    laboratory = Laboratory(arguments.build, arguments.volumes)
    cases = all_cases(arguments.huge)
    for case in cases:
        busy = max(busy, busy_share())
        laboratory.measure(case, arguments.quick)
    single = [{"volume": c.name, "program": p.label, "runs": runs} for c in cases for p, runs in c.runs.items()]
    (arguments.build / "results.json").write_text(json.dumps(single, indent=1), encoding="utf-8")
    arguments.out.write_text(document(cases, arguments, started, busy), encoding="utf-8")
    print(f"written: {arguments.out}")


if __name__ == "__main__":
    main(sys.argv[1:])
