#!/usr/bin/python3
"""Checks which source file includes what, by the rule of volsurf's architecture.

In:  the folder that holds src and apps (default: this repository).
Out: a line `file:line: rule` for each violation, and exit code 1 if there is one.
"""

import re
import sys
from pathlib import Path

INCLUDE = re.compile(r'\s*#\s*include\s*[<"]([^>"]+)[>"]')
SOURCE_ENDINGS = {".h", ".hpp", ".cpp", ".cc"}

BELOW_STAGES = {"core", "interop"}
STAGES = {"io", "field", "topology", "surface", "phantom", "plot", "baseline", "compare"}
# What the files of each folder may include from other folders of src/volsurf.
ALLOWED_FOLDERS = {
    "core": set(),
    "interop": {"core"},
    **{stage: BELOW_STAGES for stage in STAGES},
    "pipeline": BELOW_STAGES | STAGES,
    "views": BELOW_STAGES | STAGES | {"pipeline"},
    "apps": BELOW_STAGES | STAGES | {"pipeline", "views"},
}
# The files that make volsurf_core, which a ParaView plugin uses beside another VTK: they need nothing but core.
CORE_LIBRARY = re.compile(r"(core|topology|phantom)/|field/(?!median)|surface/(?!smoothing)")
# Library, how its headers are named, the files that may include them, and how to say so.
LIBRARIES = (
    ("ITK", re.compile(r"itk\w+\.h|gdcm\w*\.h"), re.compile(r"(io|baseline)/|interop/itk_image|field/median"),
     "io, baseline, interop/itk_image, field/median"),
    ("VTK", re.compile(r"vtk\w+\.h"), re.compile(r"(interop|io|compare|baseline)/|surface/smoothing"),
     "interop, io, compare, baseline, surface/smoothing"),
    ("OpenVDB", re.compile(r"openvdb/"), re.compile(r"interop/"), "interop"),
    ("cairo", re.compile(r"cairo[\w-]*\.h"), re.compile(r"plot/"), "plot"),
    ("CGAL", re.compile(r"CGAL/"), re.compile(r"baseline/cgal_mesher\.cpp"), "baseline/cgal_mesher.cpp"),
    ("CLI11", re.compile(r"CLI/"), re.compile(r"apps/"), "apps"),
    ("TBB", re.compile(r"(oneapi/)?tbb/"), re.compile(r"core/parallel"), "core/parallel"),
)


def places(root):
    """The source files, each with its place: `topology/region_merge.h`, `apps/volsurf/main.cpp`."""
    for top, prefix in ((root / "src" / "volsurf", ""), (root / "apps", "apps/")):
        for path in sorted(top.rglob("*")):
            if path.suffix in SOURCE_ENDINGS:
                yield path, prefix + path.relative_to(top).as_posix()


def broken_rules(place, included):
    """The rules that a file in this place breaks by including this."""
    for library, header, allowed_places, where in LIBRARIES:
        if header.match(included) and not allowed_places.match(place):
            yield f"{library} is included only in {where}"
    if not included.startswith("volsurf/"):
        return
    folder, target = place.split("/")[0], included.split("/")[1]
    if target != folder and target not in ALLOWED_FOLDERS.get(folder, set()):
        yield f"{folder} does not include {target}"
    elif CORE_LIBRARY.match(place) and not CORE_LIBRARY.match(included.removeprefix("volsurf/")):
        yield f"{folder} is part of volsurf_core, which does not include {target}"


def violations(root):
    """One line for each include that breaks a rule."""
    for path, place in places(root):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            match = INCLUDE.match(line)
            for rule in broken_rules(place, match.group(1)) if match else ():
                yield f"{path.relative_to(root)}:{number}: {rule}"


def main(words):
    """Returns the exit code."""
    root = Path(words[0]) if words else Path(__file__).resolve().parent.parent
    if not (root / "src" / "volsurf").is_dir():
        sys.exit(f"check_includes.py: {root}: there is no src/volsurf in it")
    found = list(violations(root))
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
