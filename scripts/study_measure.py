"""Runs methods on scans and measures their surfaces: the work of scripts/study.py."""

import csv
import json
import math
import re
import shutil
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass, fields
from pathlib import Path

from study_results import Result
from study_scans import PYTHON, has_vtk

WORKERS = 2
NOTHING_FOUND = 4  # exit code


def available_methods(configuration, programs, notes):
    """The methods whose options the program has."""
    kept = []
    for method in configuration["methods"]:
        missing = [option for option in method.get("needs", []) if not programs.has(option)]
        if missing:
            notes.append(f"{method['name']} is left out: the help of this volsurf does not tell of \"{missing[0]}\"")
        elif "script" in method and not has_vtk():
            notes.append(f"{method['name']} is left out: {PYTHON} has no VTK")
        else:
            kept.append(method)
    return kept


def methods_of(case, methods):
    """Those that a case asks for by name, or all that stand in every case and those it asks for besides."""
    if "methods" in case:
        return [method for method in methods if method["name"] in case["methods"]]
    also = case.get("also", [])
    return [method for method in methods if not method.get("only_where_named") or method["name"] in also]


def is_default(method):
    """volsurf without an option."""
    return not method["options"] and not method.get("by_hand") and not method.get("search")


def voxel_mm(nrrd):
    """The smallest spacing of a file that volsurf-phantom wrote."""
    with open(nrrd, "rb") as file:
        header = file.read(4096).split(b"\n\n")[0].decode("latin-1")
    directions = re.search(r"^space directions: (.*)$", header, re.MULTILINE).group(1)
    axes = [[float(number) for number in axis.split(",")] for axis in re.findall(r"\(([^)]*)\)", directions)]
    return min(math.sqrt(sum(number * number for number in axis)) for axis in axes)


def vertex_rms_mm(surface):
    """Of a surface that `volsurf-compare --distance` wrote: its vertices' distances from the truth, root mean square.
    NaN without VTK."""
    try:
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    except ImportError:
        return math.nan
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(surface))
    reader.Update()
    distances = vtk_to_numpy(reader.GetOutput().GetPointData().GetArray("DistanceToB")).astype(float)
    return math.sqrt((distances**2).mean())


class ScanRun:
    """All methods on one scan. Holds what earlier methods found, which later ones start from."""

    def __init__(self, programs, scans, setting, samples, folder, clean):
        self.programs, self.scans, self.setting, self.samples, self.folder = programs, scans, setting, samples, folder
        self.clean = clean  # the folder with each method's surface of the scan without noise, or None
        self.truth = scans.truths[setting.case["name"]]
        self.scan = scans.make(setting, folder / "scan.nrrd")
        self.voxel = voxel_mm(self.scan)
        self.found = {"sigma": self.voxel}  # mm; by volsurf's report, its delta too; and the best levels
        self.blurred = None
        self.nearest = {}  # mm, by method

    def run(self, methods, names, known):
        """The results of the methods of these names. What they start from, others have found by now or in `known`, the
        results of the scan from before. volsurf itself is run for that, too."""
        results = []
        for method in methods:
            before = [result for result in known if result.method == method["name"]]
            if method["name"] in names:
                results += self.run_method(method)
            elif is_default(method):
                self.measure(method, [])
            elif before:
                self.remember(method, before)
        return results

    def run_method(self, method):
        """With each parameter that its search tries."""
        results = [self.measure(method, parameter) for parameter in self.parameters(method)]
        self.remember(method, results)
        return results

    def remember(self, method, results):
        """The value that was best for a method that is searched."""
        best = min(results, key=lambda result: result.assd_mm)
        if best.parameter and not math.isinf(best.assd_mm):
            self.found[method["name"]] = float(best.parameter.split()[-1])

    def parameters(self, method):
        """What is added to a method's options, in turn: values around one that was found before, or multiples of it."""
        search = method.get("search")
        if not search:
            return [[]]
        start = self.found.get(search["from"])
        if start is None:
            start = self.setting.case.get("middle")
        if start is None:
            return [[]]
        values = [start * factor for factor in search.get("times", [])]
        values += [start + part * self.setting.case.get("contrast", 0) for part in search.get("plus", [])]
        return [[search["option"], f"{value:.4g}"] for value in values]

    def measure(self, method, parameter):
        """One surface: its Result."""
        setting = self.setting
        result = Result(*setting.key, method["name"], " ".join(parameter))
        with tempfile.TemporaryDirectory(dir=self.folder) as scratch:
            surface = Path(scratch) / "surface.vtp"
            started = time.perf_counter()
            process = self.extract(method, parameter, surface)
            result.seconds = time.perf_counter() - started
            if process.returncode != 0:
                result.status = "nothing found" if process.returncode == NOTHING_FOUND else process.stderr.strip() or "failed"
                return result
            if "--level" in method["options"]:
                result.parameter = f"level {process.stdout.strip()}"
            if not parameter and is_default(method):
                self.take_report(surface.with_suffix(".json"))
                result.parameter = f"delta {self.found['delta']:g}"
            self.compare(surface, result)
            self.compare_with_clean(surface, result)
        return result

    def extract(self, method, parameter, surface):
        """Makes the surface by the program or the script."""
        case = self.setting.case
        words = [*method["options"], *parameter]
        if parameter and not method.get("rival") and "oversampling" in self.found:
            words += ["--oversample", self.found["oversampling"]]  # another sigma or delta on the same grid
        if method.get("by_hand"):
            words += case["by_hand"]
        words += case.get("parts", ["--keep", "1"]) if method.get("of_parts") else case.get("select", [])
        if "script" in method:
            if "best" in words:
                words += ["--truth", self.truth.surface, "--between", *case["levels"]]
        else:
            words += ["--threads", 1, "-q", "--report", surface.with_suffix(".json")]
        return self.programs.run(method.get("script", "volsurf"), self.input_of(method), *words, "-o", surface)

    def input_of(self, method):
        if not method.get("blur"):
            return self.scan
        if self.blurred is None:
            self.blurred = self.scans.blur(self.scan, self.found["sigma"], self.folder / "blurred.nrrd")
        return self.blurred

    def take_report(self, path):
        """What volsurf chose by itself."""
        options = json.loads(path.read_text(encoding="utf-8"))["options"]
        self.found["sigma"], self.found["delta"] = options["sigma_mm"], options["delta"]
        self.found["oversampling"] = options["oversampling"]

    def compare(self, surface, result):
        metrics, message = self.compared(surface, self.truth.measured)
        if metrics is None:
            result.status = message
        else:
            result.take(metrics, self.voxel)
            if self.setting.case.get("bars"):
                result.vertex_rms_voxels = vertex_rms_mm(surface.with_suffix(".distance.vtp")) / self.voxel

    def compared(self, surface, reference):
        """volsurf-compare's numbers, or None and what it said."""
        found = surface.with_suffix(".found.json")
        distance = ["--distance", surface.with_suffix(".distance.vtp")] if self.setting.case.get("bars") else []
        process = self.programs.run(
            "volsurf-compare", surface, reference, "--samples", self.samples, "--spacing", self.voxel, "--threads", 1,
            "-q", "--json", found, *distance)
        if not found.exists():
            return None, process.stderr.strip()
        return json.loads(found.read_text(encoding="utf-8"))["metrics"], ""

    def compare_with_clean(self, surface, result):
        """How far noise has moved the surface of the same method."""
        if self.clean is None:
            return
        own = self.clean / (re.sub(r"\W", "_", result.method) + ".vtp")
        if self.setting.noise == "none":
            if result.assd_mm <= self.nearest.get(result.method, math.inf):
                self.nearest[result.method] = result.assd_mm
                shutil.copy(surface, own)
        elif own.exists():
            metrics, _ = self.compared(surface, own)
            if metrics is not None:
                result.moved_assd_voxels = metrics["assd"] / self.voxel
                result.moved_hd95_voxels = metrics["hd95"] / self.voxel


def tasks_of(settings):
    """Lists of scans that one worker does in turn: first what every case needs, the longest first, then further seeds.
    Where each method's own surface without noise is wanted, all scans of a case are one task; elsewhere each is by
    itself."""
    tasks = {}
    for setting in settings:
        tasks.setdefault(setting.case["name"] if setting.case.get("stability") else setting.key, []).append(setting)
    for task in tasks.values():
        task.sort(key=lambda setting: setting.noise != "none")
    return sorted(tasks.values(), key=lambda task: (task[0].seed, -len(task) * task[0].case.get("seconds", 1)))


class Table:
    """results.csv, which grows by a scan at a time."""

    def __init__(self, path, known):
        self.file = open(path, "w", encoding="utf-8", newline="")
        self.writer = csv.DictWriter(self.file, [field.name for field in fields(Result)])
        self.writer.writeheader()
        self.add(known)

    def add(self, results):
        self.writer.writerows(map(asdict, results))
        self.file.flush()

    def close(self):
        self.file.close()


@dataclass
class StudyWork:
    """What is to be done."""

    tasks: list  # of lists of (setting, names of the methods that are run on it)
    methods: list
    known: list  # results from before
    samples: int  # of each surface


def run_task(programs, scans, task, work):
    """The results of each scan of a task, in turn."""
    with tempfile.TemporaryDirectory(dir=scans.folder) as clean:
        for setting, names in task:
            with tempfile.TemporaryDirectory(dir=scans.folder) as folder:
                keep = Path(clean) if setting.case.get("stability") else None
                run = ScanRun(programs, scans, setting, work.samples, Path(folder), keep)
                known = [result for result in work.known if result.scan == setting.key]
                yield setting, run.run(methods_of(setting.case, work.methods), names, known)


def run_all(programs, scans, work, table, most_seconds):
    """Two tasks at a time. Each scan's results are written when it is done. None is begun after `most_seconds`."""
    whole, done, lock = sum(map(len, work.tasks)), [0], threading.Lock()
    started = time.perf_counter()

    def run_one(task):
        found = []
        if time.perf_counter() - started > most_seconds:
            return found
        for setting, results in run_task(programs, scans, task, work):
            found += results
            with lock:
                table.add(results)
                done[0] += 1
                seconds = time.perf_counter() - started
                name = f"{setting.key[0]}, {setting.noise}, bias {setting.bias:g}, seed {setting.seed}"
                print(f"study.py: {seconds:.0f} s: {done[0]} of {whole}: {name}", file=sys.stderr, flush=True)
            if seconds > most_seconds:
                break
        return found

    with ThreadPoolExecutor(WORKERS) as pool:
        return [result for results in pool.map(run_one, work.tasks) for result in results]
