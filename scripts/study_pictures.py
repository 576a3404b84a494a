"""The pictures of scripts/study.py: surfaces of one scan side by side."""

import json
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from study_scans import SCRIPTS, Setting

IN_A_ROW = 3
SIZE = "480x440"
MOST_SECONDS = 60  # of one surface: what takes longer is told of, but not shown


@dataclass(frozen=True)
class Figure:
    title: str
    about: str
    rows: list  # PNG files as bytes


def draw_figures(programs, scans, configuration):
    """All that can be drawn: nothing where VTK's Python or a virtual display is missing."""
    cases = {case["name"]: case for case in configuration["cases"]}
    figures = []
    for wanted in configuration.get("figures", []):
        if wanted["case"] not in cases:
            continue
        with tempfile.TemporaryDirectory(dir=scans.folder) as folder:
            setting = Setting(cases[wanted["case"]], wanted["noise"], 0, 1)
            scan = scans.make(setting, Path(folder) / "scan.nrrd")
            rows, failures = draw(programs, scan, wanted, Path(folder))
        if rows:
            figures.append(Figure(wanted["title"], " ".join([wanted["about"], *failures]), rows))
    return figures


def draw(programs, scan, wanted, folder):
    """Rows of surfaces, and a sentence for each that could not be made."""
    made, failures = [], []
    for number, surface in enumerate(wanted["surfaces"]):
        if all(map(programs.has, surface.get("needs", []))):
            file, report = folder / f"{number}.vtp", folder / f"{number}.json"
            words = [*surface["options"], "-q", "-o", file, "--report", report]
            process = programs.run("volsurf", scan, *words, most_seconds=MOST_SECONDS)
            if process.returncode == 0:
                made.append((file, caption(surface, report)))
            else:
                failures.append(f"{surface['caption']}: {process.stderr.strip()}.")
    rows = [made[start : start + IN_A_ROW] for start in range(0, len(made), IN_A_ROW)]
    pictures = [picture(row, folder / "picture.png", wanted.get("view")) for row in rows]
    return [png for png in pictures if png], failures


def caption(surface, report):
    """With the number of parts of which the largest are shown."""
    counts = json.loads(report.read_text(encoding="utf-8"))["counts"]
    parts = counts["components"]
    return f"{surface['caption']}: largest of {parts:,} parts" if parts > 1 else surface["caption"]


def picture(row, png, view):
    """A row as the bytes of a PNG; None where it cannot be drawn."""
    files, captions = zip(*row)
    command = [SCRIPTS / "render.py", *files, "--png", png, "--size", SIZE, "--together", "--captions", *captions]
    command += ["--view", view] if view else []
    if subprocess.run(list(map(str, command)), capture_output=True, check=False).returncode != 0:
        return None
    return png.read_bytes()
