"""The programs that scripts/study.py runs, and the scans, references and truths that it makes with them."""

import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parent
PYTHON = "/usr/bin/python3"  # Debian's, which has VTK
MOST_SECONDS = 600  # of one process


@dataclass(frozen=True)
class Setting:
    """One scan: a case of the configuration with one noise, bias and seed."""

    case: dict
    noise: str
    bias: float
    seed: int

    @property
    def key(self):
        return (self.case["name"], self.noise, self.bias, self.seed)


def settings_of(configuration):
    """All scans of all cases. Without noise, seeds make no difference."""
    for case in configuration["cases"]:
        for bias in case.get("bias", [0]):
            for noise in case["noise"] if not bias else case["noise_with_bias"]:
                for seed in case.get("seeds", [1]) if noise != "none" else [1]:
                    yield Setting(case, noise, float(bias), seed)


class Programs:
    """The three programs, wherever a build or an installation has them."""

    def __init__(self, folder):
        self.paths = {name: self.find(folder, name) for name in ("volsurf", "volsurf-phantom", "volsurf-compare")}
        self.options = " ".join(self.run("volsurf", "--help").stdout.split())
        self.version = self.run("volsurf", "--version").stdout.strip()

    @staticmethod
    def find(folder, name):
        for path in (folder / "apps" / name / name, folder / name, folder / "bin" / name):
            if path.is_file():
                return path
        sys.exit(f"study.py: {folder}: there is no program {name} in it")

    def run(self, name, *words, most_seconds=MOST_SECONDS):
        """Runs a program, or a script beside this one. One that takes too long counts as one that fails."""
        start = [PYTHON, SCRIPTS / name] if name.endswith(".py") else [self.paths[name]]
        command = [*map(str, start), *map(str, words)]
        try:
            return subprocess.run(command, capture_output=True, text=True, timeout=most_seconds, check=False)
        except subprocess.TimeoutExpired:
            return subprocess.CompletedProcess(command, 1, "", f"not done after {most_seconds} s")

    def must_run(self, name, *words):
        process = self.run(name, *words)
        if process.returncode != 0:
            sys.exit(f"study.py: {' '.join(process.args)}: {process.stderr.strip()}")

    def has(self, words):
        """Whether the help of volsurf says so: an option, or a part of its text."""
        return re.search(rf"(?<![\w-]){re.escape(words)}(?![\w-])", self.options) is not None


def has_vtk():
    """True where Debian's python3-vtk9 is installed."""
    command = [PYTHON, "-c", "import vtkmodules.vtkFiltersCore"]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


@dataclass(frozen=True)
class Truth:
    """What a case is measured against, and the same as a surface, for those who search."""

    measured: Path
    surface: Path


class Scans:
    """Makes the scans, each with its truth, in a folder. The truth of a case is made once."""

    def __init__(self, programs, folder, data):
        self.programs, self.folder, self.data = programs, folder, data
        self.truths = {}

    def make_truths(self, cases):
        made = {}  # a truth that several cases share is made once
        for number, case in enumerate(cases):
            what = str(case.get("reference", case.get("phantom")))
            if what not in made:
                make = self.truth_of_scan if "scan" in case else self.truth_of_phantom
                made[what] = make(case, self.folder / f"truth{number}")
            self.truths[case["name"]] = made[what]

    def truth_of_phantom(self, case, path):
        surface = path.with_suffix(".vtp")
        self.programs.must_run(
            "volsurf-phantom", *case["phantom"], "-o", path.with_suffix(".nrrd"), "--truth-surface", surface)
        return Truth(surface, surface)

    def truth_of_scan(self, case, path):
        labels, surface = path.with_suffix(".nrrd"), path.with_suffix(".vtp")
        scan, *options = case["reference"]
        self.programs.must_run("study_reference.py", self.data / scan, *options, "-o", labels)
        if has_vtk():
            self.programs.must_run("isosurface.py", labels, "--level", 0.5, "-o", surface)
        return Truth(labels, surface)

    def make(self, setting, path):
        noise = ["--noise", setting.noise, "--seed", setting.seed]
        if "scan" in setting.case:
            self.programs.must_run("volsurf-phantom", "--scan", self.data / setting.case["scan"], *noise, "-o", path)
        else:
            bias = ["--bias", setting.bias]
            self.programs.must_run("volsurf-phantom", *setting.case["phantom"], *noise, *bias, "-o", path)
        return path

    def blur(self, scan, sigma_mm, path):
        """By the Gaussian that volsurf's gradient takes."""
        self.programs.must_run("volsurf-phantom", "--scan", scan, "--blur", sigma_mm, "-o", path)
        return path
