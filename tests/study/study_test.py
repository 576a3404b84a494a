#!/usr/bin/python3
"""Laws of scripts/study.py, on its small configuration.

In:  the build folder.
Out: a line for each law that does not hold, and exit code 1 if there is one.
"""

import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))

from best_level import best_level  # noqa: E402
from study_results import Result, best_of_each  # noqa: E402
from study_tables import Contest, Study, default_table, losses, reason  # noqa: E402

broken = []


def law(name, holds):
    if not holds:
        broken.append(name)


def result(method, seed, assd, parameter=""):
    return Result("ball", "none", 0, seed, method, parameter, assd_mm=2 * assd, assd_voxels=assd, hd95_voxels=assd)


def check_scores():
    """A search takes the best parameter of each seed; one seed that is lost loses the scan."""
    scores = best_of_each([result("a", 1, 0.3, "x 1"), result("a", 1, 0.1, "x 2"), result("a", 2, 0.2, "x 1"),
                           result("b", 1, 0.1), Result("ball", "none", 0, 2, "b", status="nothing found")])
    scores = scores["ball", 0, "none"]
    law("the mean over seeds is of each one's best parameter", math.isclose(scores["a"].assd, 0.15))
    law("the parameters that were best are named", scores["a"].parameters == ("x 1", "x 2"))
    law("the worst seed is told", math.isclose(scores["a"].worst_assd, 0.2))
    law("a method that found nothing on one seed has lost", math.isinf(scores["b"].assd) and scores["b"].lost == 1)


def check_losses():
    """What volsurf lost is told, worst first."""
    configuration = {"ours": "volsurf", "cases": [{"name": "ball"}],
                     "methods": [{"name": "volsurf"}, {"name": "rival", "rival": True}]}
    scores = best_of_each([result("volsurf", 1, 0.3), result("rival", 1, 0.1)])
    found = losses(Study(configuration, scores, 2, []))
    law("a nearer rival is a loss", found[0] == Contest(("ball", 0, "none"), "assd", 0.3, "rival", 0.1))
    scores = best_of_each([result("volsurf", 1, 0.1), result("rival", 1, 0.3)])
    law("a farther rival is none", not losses(Study(configuration, scores, 2, [])))


def check_reasons():
    """Why volsurf lost is what its other options gave on the same scan, and not said where none is nearer."""
    configuration = {"ours": "volsurf", "cases": [{"name": "ball"}],
                     "methods": [{"name": "volsurf"}, {"name": "rival", "rival": True},
                                 {"name": "wide", "variant": "a wider Gaussian"}],
                     "defaults": [{"about": "--sigma", "methods": ["wide"]}]}
    for wide, said in ((0.05, "nearer than the rival"), (0.2, "the rival is nearer still"), (0.4, "none of")):
        scores = best_of_each([result("volsurf", 1, 0.3), result("rival", 1, 0.1), result("wide", 1, wide)])
        study = Study(configuration, scores, 3, [])
        law(f"a wider Gaussian at {wide} is told as it is", said in reason(study, losses(study)[0]))
        law("a default is set beside the other value",
            default_table(study)[1][2:5] == ["1", "0.300", f"{wide:.3f}"])


def check_search():
    """The best level is found to a small part of the interval, also at its ends."""
    for wanted in (125, 131.7, 150, 174.9):
        law(f"the level {wanted} is found", abs(best_level(lambda level: abs(level - wanted), 125, 175) - wanted) < 0.6)


def run_small_study(build, folder, *words):
    """The rows of its table; None where it fails."""
    command = [sys.executable, SCRIPTS / "study.py", SCRIPTS / "study_small.json", "--programs", build, "--out", folder,
               "--markdown", folder / "page.md", *words]
    process = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
    law(f"the small study runs: {process.stderr}", process.returncode == 0)
    if process.returncode != 0:
        return None
    with open(folder / "results.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def check_resume(build, folder):
    """What is measured is kept; what is missing is measured."""
    table = folder / "results.csv"
    lines = table.read_text(encoding="utf-8").splitlines(keepends=True)
    without_none = [line for line in lines if not line.startswith("sphere,none")]
    rows = run_small_study(build, folder, "--resume")
    law("a whole table is not measured again", rows is not None and table.read_text(encoding="utf-8") == "".join(lines))
    table.write_text("".join(without_none), encoding="utf-8")
    rows = run_small_study(build, folder, "--resume") or []
    law("a missing scan is measured", any(row["noise"] == "none" for row in rows))
    without_wide = [line for line in lines if "sigma x 1.5" not in line]
    table.write_text("".join(without_wide), encoding="utf-8")
    rows = run_small_study(build, folder, "--resume") or []
    again = table.read_text(encoding="utf-8").splitlines(keepends=True)
    law("what is known of a scan is kept, to the time it took", set(without_wide) <= set(again))
    law("a missing method is measured from where it started before",
        [row["parameter"] for row in rows if row["method"] == "volsurf, sigma x 1.5"] == 2 * ["--sigma 1.5"])


def check_small_study(build, folder):
    """The programs and the script together."""
    rows = run_small_study(build, folder)
    if rows is None:
        return
    ours = [row for row in rows if row["method"] == "volsurf"]
    law("there is a row for each scan", len(ours) == 2)
    tried = [row["parameter"] for row in rows if row["method"] == "volsurf, sigma x 1.5"]
    law("a multiple of what volsurf chose is tried", tried == ["--sigma 1.5", "--sigma 1.5"])
    moved = [float(row["moved_assd_voxels"]) for row in ours if row["noise"] != "none"]
    law("noise moves volsurf's surface by less than a tenth of a voxel", all(0 < value < 0.1 for value in moved))
    law("volsurf is within a tenth of a voxel of the ball", all(float(row["assd_voxels"]) < 0.1 for row in ours))
    hopeless = [row for row in rows if row["method"] == "a delta that leaves nothing"]
    law("what finds nothing is a row, and lost",
        len(hopeless) == 2 and all(row["status"] == "nothing found" and row["assd_mm"] == "inf" for row in hopeless))
    page = (folder / "index.html").read_text(encoding="utf-8")
    law("the page tells what it left out", "missing.nrrd" in page and "--unknown-option" in page)
    law("the page needs no other file", "<svg" in page and "src='http" not in page and "href" not in page)
    law("the page and the summary hold the same number",
        all(f"{float(row['assd_voxels']):.3f}" in text for row in ours
            for text in (page, (folder / "page.md").read_text(encoding="utf-8"))))
    check_resume(build, folder)


def main(words):
    """Returns the exit code."""
    check_scores()
    check_losses()
    check_reasons()
    check_search()
    with tempfile.TemporaryDirectory() as folder:
        check_small_study(Path(words[0]), Path(folder))
    print("\n".join(broken), end="\n" if broken else "")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
