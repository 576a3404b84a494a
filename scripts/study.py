#!/usr/bin/python3
"""Measures volsurf's surfaces, and those of what a user would use instead, against the truth.

In:  a configuration such as scripts/study.json; the folder with the programs (a build folder), and one with real scans
     (scripts/fetch_data.sh). Cases whose scan and methods whose option is missing are left out, and the page says so.
Out: in a folder: results.csv, a row for each measurement; index.html, which needs no other file. By choice a summary in
     Markdown. Every number is from the runs.

A method with a "search" is given the truth: an option is searched for the value with the smallest mean distance.
volsurf gets no such help.
"""

import argparse
import csv
import json
import math
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass, fields
from pathlib import Path

import study_page
from study_results import Result, best_of_each

REPOSITORY = Path(__file__).resolve().parent.parent
PYTHON = "/usr/bin/python3"  # Debian's, which has VTK
WORKERS = 2
MOST_SECONDS = 600  # of one process


@dataclass(frozen=True)
class Setting:
    """One scan: a case of the configuration with one noise, bias and seed."""

    case: dict
    noise: str
    bias: float
    seed: int


class Programs:
    """The three programs, wherever a build or an installation has them."""

    def __init__(self, folder):
        self.paths = {name: self.find(folder, name) for name in ("volsurf", "volsurf-phantom", "volsurf-compare")}
        self.options = self.run("volsurf", "--help").stdout

    @staticmethod
    def find(folder, name):
        for path in (folder / "apps" / name / name, folder / name, folder / "bin" / name):
            if path.is_file():
                return path
        sys.exit(f"study.py: {folder}: there is no program {name} in it")

    def run(self, name, *words):
        """Runs a program, or a script beside this one. One that hangs counts as one that fails."""
        start = [PYTHON, REPOSITORY / "scripts" / name] if name.endswith(".py") else [self.paths[name]]
        command = [*map(str, start), *map(str, words)]
        try:
            return subprocess.run(command, capture_output=True, text=True, timeout=MOST_SECONDS, check=False)
        except subprocess.TimeoutExpired:
            return subprocess.CompletedProcess(command, 1, "", f"{name}: stopped after {MOST_SECONDS} s")

    def must_run(self, name, *words):
        process = self.run(name, *words)
        if process.returncode != 0:
            sys.exit(f"study.py: {' '.join(process.args)}: {process.stderr.strip()}")

    def has(self, option):
        return re.search(rf"(?<![\w-]){re.escape(option)}(?![\w-])", self.options) is not None


# --- What there is to do


def settings_of(configuration):
    """All scans of all cases. Without noise, seeds make no difference."""
    for case in configuration["cases"]:
        for bias in case.get("bias", [0]):
            for noise in case["noise"] if not bias else case["noise_with_bias"]:
                for seed in case.get("seeds", [1]) if noise != "none" else [1]:
                    yield Setting(case, noise, bias, seed)


def available_cases(configuration, data, notes):
    """The cases whose scan is there."""
    kept = []
    for case in configuration["cases"]:
        missing = [case[key] for key in ("scan", "truth") if key in case and not (data and (data / case[key]).exists())]
        if missing:
            notes.append(f"{case['name']} is left out: there is no {missing[0]}")
        else:
            kept.append(case)
    return kept


def available_methods(configuration, programs, notes):
    """The methods whose options the program has."""
    kept = []
    for method in configuration["methods"]:
        missing = [option for option in method.get("needs", []) if not programs.has(option)]
        if missing:
            notes.append(f"{method['name']} is left out: this volsurf has no {missing[0]}")
        elif "script" in method and not has_vtk():
            notes.append(f"{method['name']} is left out: {PYTHON} has no VTK")
        else:
            kept.append(method)
    return kept


def has_vtk():
    """True where Debian's python3-vtk9 is installed."""
    command = [PYTHON, "-c", "import vtkmodules.vtkFiltersCore"]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def methods_of(case, methods):
    """Those that a case asks for by name, or all that stand in every case."""
    if "methods" in case:
        return [method for method in methods if method["name"] in case["methods"]]
    return [method for method in methods if not method.get("only_where_named")]


# --- Scans and their truth


class Scans:
    """Makes the scans, each with its truth, in a folder. The truth of a case is made once."""

    def __init__(self, programs, folder, data):
        self.programs, self.folder, self.data = programs, folder, data
        self.truths = {}

    def make_truths(self, cases):
        for number, case in enumerate(cases):
            if "truth" in case:
                self.truths[case["name"]] = self.data / case["truth"]
                continue
            truth = self.folder / f"truth{number}.vtp"
            clean = self.folder / "clean.nrrd"
            self.programs.must_run("volsurf-phantom", *case["phantom"], "-o", clean, "--truth-surface", truth)
            self.truths[case["name"]] = truth

    def make(self, setting, path):
        noise = ["--noise", setting.noise, "--seed", setting.seed]
        if "scan" in setting.case:
            self.programs.must_run("volsurf-phantom", "--scan", self.data / setting.case["scan"], *noise, "-o", path)
        else:
            bias = ["--bias", setting.bias]
            self.programs.must_run("volsurf-phantom", *setting.case["phantom"], *noise, *bias, "-o", path)
        return path

    def blur(self, scan, path):
        """By the Gaussian that volsurf's gradient takes by default."""
        self.programs.must_run("volsurf-phantom", "--scan", scan, "--blur", voxel_mm(scan), "-o", path)
        return path


def voxel_mm(nrrd):
    """The smallest spacing of a file that volsurf-phantom wrote."""
    with open(nrrd, "rb") as file:
        header = file.read(4096).split(b"\n\n")[0].decode("latin-1")
    directions = re.search(r"^space directions: (.*)$", header, re.MULTILINE).group(1)
    axes = [[float(number) for number in axis.split(",")] for axis in re.findall(r"\(([^)]*)\)", directions)]
    return min(math.sqrt(sum(number * number for number in axis)) for axis in axes)


# --- Running


def search_values(search, distance_of):
    """Calls distance_of(value) with each value, then with those half-way to the neighbours of the best one, `halvings`
    times."""
    distances = {value: distance_of(value) for value in search["values"]}
    step = search["values"][1] - search["values"][0]
    for _ in range(search["halvings"]):
        step /= 2
        best = min(distances, key=distances.get)
        for value in (best - step, best + step):
            distances[value] = distance_of(value)


def measure(programs, setting, method, parameter, scan, truth, samples):
    """One surface: its Result."""
    result = Result(
        setting.case["name"], setting.noise, setting.bias, setting.seed, method["name"], " ".join(parameter))
    with tempfile.TemporaryDirectory(dir=scan.parent) as folder:
        surface, found = Path(folder) / "surface.vtp", Path(folder) / "found.json"
        words = [*method["options"], *parameter]
        if "script" in method:
            words += setting.case.get("script_select", [])
        else:
            words += [*setting.case.get("select", []), "--threads", 1, "-q"]
        started = time.perf_counter()
        process = programs.run(method.get("script", "volsurf"), scan, *words, "-o", surface)
        result.seconds = time.perf_counter() - started
        if process.returncode != 0:
            result.status = "nothing found" if process.returncode == 4 else process.stderr.strip() or "failed"
            return result
        voxel = voxel_mm(scan)
        process = programs.run(
            "volsurf-compare", surface, truth, "--samples", samples, "--spacing", voxel, "--threads", 1, "-q",
            "--json", found)
        if not found.exists():
            result.status = process.stderr.strip()
            return result
        result.take(json.loads(found.read_text(encoding="utf-8"))["metrics"], voxel)
    return result


def run_method(programs, setting, method, scan, truth, samples):
    """A method on one scan, with each parameter that its search tries."""
    if "search" not in method:
        return [measure(programs, setting, method, [], scan, truth, samples)]
    results = []

    def distance_of(value):
        parameter = [method["search"]["option"], f"{value:g}"]
        results.append(measure(programs, setting, method, parameter, scan, truth, samples))
        return results[-1].assd_mm

    search_values(setting.case[method["search"]["over"]], distance_of)
    return results


def run_setting(programs, scans, setting, methods, samples):
    """All methods on one scan."""
    results = []
    with tempfile.TemporaryDirectory(dir=scans.folder) as folder:
        scan = scans.make(setting, Path(folder) / "scan.nrrd")
        blurred = None
        for method in methods_of(setting.case, methods):
            if method.get("blur") and blurred is None:
                blurred = scans.blur(scan, Path(folder) / "blurred.nrrd")
            given = blurred if method.get("blur") else scan
            truth = scans.truths[setting.case["name"]]
            results += run_method(programs, setting, method, given, truth, samples)
    return results


def run_all(programs, scans, settings, methods, samples, table):
    """Two scans at a time. Each one's results are written when it is done; they return in the order of the settings."""
    done, lock = [0], threading.Lock()
    with open(table, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, [field.name for field in fields(Result)])
        writer.writeheader()

        def run_one(setting):
            results = run_setting(programs, scans, setting, methods, samples)
            with lock:
                writer.writerows(map(asdict, results))
                file.flush()
                done[0] += 1
                name = f"{setting.case['name']}, {setting.noise}, bias {setting.bias}, seed {setting.seed}"
                print(f"study.py: {done[0]} of {len(settings)}: {name}", file=sys.stderr, flush=True)
            return results

        with ThreadPoolExecutor(WORKERS) as pool:
            return [result for results in pool.map(run_one, settings) for result in results]


# --- Pictures


def draw_pictures(programs, scans, configuration, cases):
    """The PNG of each picture with its caption; nothing where VTK's Python or a virtual display is missing."""
    pictures = []
    for wanted in configuration.get("pictures", []):
        case = next((case for case in cases if case["name"] == wanted["case"]), None)
        if case is None:
            continue
        with tempfile.TemporaryDirectory(dir=scans.folder) as folder:
            scan = scans.make(Setting(case, wanted["noise"], 0, 1), Path(folder) / "scan.nrrd")
            png = draw(programs, scan, wanted["surfaces"], Path(folder))
            if png:
                pictures.append((f"{wanted['case']}, noise {wanted['noise']}", png))
    return pictures


def draw(programs, scan, surfaces, folder):
    """One row of surfaces as the bytes of a PNG."""
    files, captions = [], []
    for number, surface in enumerate(surfaces):
        file = folder / f"{number}.vtp"
        if programs.run("volsurf", scan, *surface["options"], "-q", "-o", file).returncode == 0:
            files.append(file)
            captions.append(surface["caption"])
    png = folder / "picture.png"
    script = REPOSITORY / "scripts" / "render.py"
    command = [script, *files, "--png", png, "--size", "480x440", "--captions", *captions]
    if files and subprocess.run(list(map(str, command)), capture_output=True, check=False).returncode == 0:
        return png.read_bytes()
    return None


# --- The program


def parse_arguments(words):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("configuration", type=Path, metavar="CONFIG.json")
    parser.add_argument("--out", type=Path, required=True, metavar="FOLDER")
    parser.add_argument("--programs", type=Path, default=REPOSITORY / "build" / "release", metavar="FOLDER")
    parser.add_argument("--data", type=Path, metavar="FOLDER", help="real scans")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the summary here, too")
    parser.add_argument("--page-only", action="store_true", help="make the page anew from FOLDER/results.csv")
    return parser.parse_args(words)


def main(words):
    arguments = parse_arguments(words)
    configuration = json.loads(arguments.configuration.read_text(encoding="utf-8"))
    programs = Programs(arguments.programs)
    notes = []
    cases = available_cases(configuration, arguments.data, notes)
    methods = available_methods(configuration, programs, notes)
    configuration = {**configuration, "cases": cases, "methods": methods}
    arguments.out.mkdir(parents=True, exist_ok=True)
    started = time.perf_counter()
    work = Path(tempfile.mkdtemp(prefix="study-"))
    try:
        scans = Scans(programs, work, arguments.data)
        table = arguments.out / "results.csv"
        if arguments.page_only:
            with open(table, encoding="utf-8", newline="") as file:
                results = [Result.from_row(row) for row in csv.DictReader(file)]
        else:
            scans.make_truths(cases)
            settings = sorted(settings_of(configuration), key=lambda setting: setting.seed)
            results = run_all(programs, scans, settings, methods, configuration["samples"], table)
            print(f"study.py: {len(results)} surfaces in {time.perf_counter() - started:.0f} s", file=sys.stderr)
        pictures = draw_pictures(programs, scans, configuration, cases)
    finally:
        shutil.rmtree(work)
    planned = len(list(settings_of(configuration)))
    scans_measured = len({(result.case, result.noise, result.bias_field, result.seed) for result in results})
    if scans_measured < planned:
        notes.append(f"Only {scans_measured} of the {planned} scans of the configuration (cases, noise and seeds) were run.")
    measured = {result.case for result in results}
    notes += [f"{case['name']} is left out: no result" for case in cases if case["name"] not in measured]
    configuration["cases"] = [case for case in cases if case["name"] in measured]
    study = study_page.Study(configuration, best_of_each(results), len(results), notes)
    (arguments.out / "index.html").write_text(study_page.html_page(study, pictures), encoding="utf-8")
    if arguments.markdown:
        arguments.markdown.write_text(study_page.markdown_page(study), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
