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

from study_page import Contest, Study, losses  # noqa: E402
from study_results import Result, best_of_each  # noqa: E402

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


def check_small_study(build, folder):
    """The programs and the script together."""
    command = [sys.executable, SCRIPTS / "study.py", SCRIPTS / "study_small.json", "--programs", build, "--out", folder,
               "--markdown", folder / "page.md"]
    process = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
    law(f"the small study runs: {process.stderr}", process.returncode == 0)
    if process.returncode != 0:
        return
    with open(folder / "results.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    ours = [row for row in rows if row["method"] == "volsurf"]
    law("there is a row for each scan", len(ours) == 2)
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


def main(words):
    """Returns the exit code."""
    check_scores()
    check_losses()
    with tempfile.TemporaryDirectory() as folder:
        check_small_study(Path(words[0]), Path(folder))
    print("\n".join(broken), end="\n" if broken else "")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
