#!/usr/bin/python3
"""Measures volsurf's surfaces, and those of what a user would use instead, against the truth.

In:  a configuration such as scripts/study.json; the folder with the programs (a build folder), and one with real scans
     (scripts/fetch_data.sh). Cases whose scan and methods whose option is missing are left out, and the page says so.
Out: in a folder: results.csv, a row for each measurement; index.html, which needs no other file. By choice a summary in
     Markdown. Every number is from the runs.

A method that is "told" the truth has an option searched for the value with the smallest mean distance. volsurf gets no
such help.
"""

import argparse
import json
import math
import resource
import shutil
import sys
import tempfile
import time
from pathlib import Path

import study_page
from study_measure import StudyWork, Table, available_methods, methods_of, run_all, tasks_of
from study_pictures import draw_figures
from study_results import best_of_each, read_results
from study_scans import Programs, Scans, settings_of
from study_tables import Study

REPOSITORY = Path(__file__).resolve().parent.parent


def available_cases(configuration, data, names, notes):
    """The cases whose scan is there; of those that are asked for, if any are."""
    known = [case["name"] for case in configuration["cases"]]
    for name in names:
        if name not in known:
            sys.exit(f"study.py: --case: there is no {name!r}; there are {', '.join(known)}")
    if names:
        notes.append(f"Only these cases were asked for: {', '.join(names)}.")
    kept = []
    for case in configuration["cases"]:
        if names and case["name"] not in names:
            continue
        if "scan" in case and not (data and (data / case["scan"]).exists()):
            notes.append(f"{case['name']} is left out: there is no {case['scan']}")
        else:
            kept.append(case)
    return kept


def in_order(results, settings, methods):
    """As the configuration has them, whichever was done first; without what it does not have."""
    scans = {setting.key: number for number, setting in enumerate(settings)}
    names = {method["name"]: number for number, method in enumerate(methods)}
    kept = [result for result in results if result.scan in scans and result.method in names]
    return sorted(kept, key=lambda result: (scans[result.scan], names[result.method]))


def open_tasks(settings, methods, known):
    """What is still to be done, and the results of the rest. A scan whose methods all have a result is done; of others
    the methods that have none are run, and what these start from is taken from the results that there are. Where
    noise's effect is measured, a method is run on all scans of its case or on none."""
    measured = {}
    for result in known:
        measured.setdefault(result.scan, set()).add(result.method)

    def missing_in(settings):
        return {method["name"] for setting in settings for method in methods_of(setting.case, methods)
                if method["name"] not in measured.get(setting.key, set())}

    tasks = []
    again = set()
    for task in tasks_of(settings):
        names = missing_in(task)
        everywhere = names and task[0].case.get("stability")
        tasks.append([(setting, names) for setting in task if everywhere or missing_in([setting])])
        again |= {(setting.key, name) for setting, names in tasks[-1] for name in names}
    return list(filter(None, tasks)), [result for result in known if (result.scan, result.method) not in again]


def measure_all(programs, scans, configuration, arguments):
    """Runs what there is to do; the results, in order."""
    table = arguments.out / "results.csv"
    settings, methods = list(settings_of(configuration)), configuration["methods"]
    known = read_results(table) if table.exists() and (arguments.resume or arguments.page_only) else []
    tasks, kept = open_tasks(settings, methods, known)
    if arguments.page_only:
        return in_order(known, settings, methods)
    to_do = {setting.case["name"] for task in tasks for setting, _ in task}
    scans.make_truths([case for case in configuration["cases"] if case["name"] in to_do])
    rows = Table(table, kept)
    try:
        work = StudyWork(tasks, methods, kept, configuration["samples"])
        kept = kept + run_all(programs, scans, work, rows, 60 * arguments.minutes)
    finally:
        rows.close()
    return in_order(kept, settings, methods)


def missing(configuration, results):
    """What the page says of scans without a result."""
    planned = {setting.key for setting in settings_of(configuration)}
    measured = {result.scan for result in results}
    notes = []
    if planned - measured:
        notes.append(f"Only {len(measured)} of the {len(planned)} scans of these cases (with noise, bias and seeds) were run.")
    found = {result.case for result in results}
    notes += [f"{case['name']} is left out: no result" for case in configuration["cases"] if case["name"] not in found]
    return notes


def parse_arguments(words):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("configuration", type=Path, metavar="CONFIG.json")
    parser.add_argument("--out", type=Path, required=True, metavar="FOLDER")
    parser.add_argument("--programs", type=Path, default=REPOSITORY / "build" / "release", metavar="FOLDER")
    parser.add_argument("--data", type=Path, metavar="FOLDER", help="real scans")
    parser.add_argument("--case", action="append", default=[], metavar="NAME", help="only this case; repeatable")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the summary here, too")
    parser.add_argument("--minutes", type=float, default=math.inf, metavar="N", help="begin no scan after so many")
    parser.add_argument("--resume", action="store_true", help="go on from FOLDER/results.csv")
    parser.add_argument("--page-only", action="store_true", help="make the page anew from FOLDER/results.csv")
    return parser.parse_args(words)


def main(words):
    arguments = parse_arguments(words)
    configuration = json.loads(arguments.configuration.read_text(encoding="utf-8"))
    programs = Programs(arguments.programs)
    notes = []
    cases = available_cases(configuration, arguments.data, arguments.case, notes)
    configuration |= {"cases": cases, "methods": available_methods(configuration, programs, notes)}
    arguments.out.mkdir(parents=True, exist_ok=True)
    started = time.perf_counter()
    work = Path(tempfile.mkdtemp(prefix="study-"))
    try:
        scans = Scans(programs, work, arguments.data)
        results = measure_all(programs, scans, configuration, arguments)
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        print(f"study.py: {len(results)} surfaces after {time.perf_counter() - started:.0f} s, "
              f"{used.ru_utime + used.ru_stime:.0f} s of processors", file=sys.stderr)
        pictures = draw_figures(programs, scans, configuration)
    finally:
        shutil.rmtree(work)
    notes += missing(configuration, results)
    measured = {result.case for result in results}
    configuration["cases"] = [case for case in cases if case["name"] in measured]
    study = Study(configuration, best_of_each(results), len(results), notes, programs.version)
    (arguments.out / "index.html").write_text(study_page.html_page(study, pictures), encoding="utf-8")
    if arguments.markdown:
        arguments.markdown.write_text(study_page.markdown_page(study), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
