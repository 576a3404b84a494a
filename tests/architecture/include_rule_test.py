#!/usr/bin/python3
"""The rule of who includes what: this repository keeps it, and a tree that breaks it is found out."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parent.parent.parent

# A file and an include that it must not have.
VIOLATIONS = (
    ("src/volsurf/core/grid.h", "volsurf/field/gradient.h"),
    ("src/volsurf/topology/hierarchy.h", "volsurf/surface/boundary.h"),
    ("src/volsurf/surface/boundary.h", "volsurf/topology/hierarchy.h"),
    ("src/volsurf/field/gradient.h", "volsurf/pipeline/run.h"),
    ("src/volsurf/interop/vtk_mesh.h", "volsurf/io/read_volume.h"),
    ("src/volsurf/topology/hierarchy.h", "itkImage.h"),
    ("src/volsurf/field/gradient.h", "itkImage.h"),
    ("src/volsurf/field/gradient.cpp", "volsurf/field/median.h"),
    ("src/volsurf/baseline/watershed.cpp", "volsurf/field/gradient.h"),
    ("src/volsurf/surface/extract.cpp", "vtkPolyData.h"),
    ("src/volsurf/surface/check.cpp", "volsurf/surface/smoothing.h"),
    ("src/volsurf/io/write_volume.cpp", "openvdb/openvdb.h"),
    ("src/volsurf/pipeline/run.cpp", "CLI/CLI.hpp"),
    ("src/volsurf/pipeline/explore.cpp", "volsurf/views/text.h"),
    ("src/volsurf/plot/chart.cpp", "volsurf/pipeline/explore.h"),
    ("src/volsurf/views/charts.cpp", "cairo.h"),
    ("src/volsurf/topology/star_sweep.cpp", "tbb/parallel_for.h"),
)
KEPT = (
    ("src/volsurf/core/parallel.cpp", "tbb/parallel_for.h"),
    ("src/volsurf/surface/smoothing.cpp", "vtkPolyData.h"),
    ("src/volsurf/surface/smoothing.cpp", "volsurf/interop/vtk_mesh.h"),
    ("src/volsurf/io/read_volume.cpp", "itkImage.h"),
    ("src/volsurf/field/median.cpp", "itkImage.h"),
    ("src/volsurf/baseline/watershed.cpp", "itkImage.h"),
    ("src/volsurf/baseline/isosurface.cpp", "vtkFlyingEdges3D.h"),
    ("src/volsurf/field/median.cpp", "volsurf/interop/itk_image.h"),
    ("src/volsurf/topology/hierarchy.cpp", "volsurf/core/radix_sort.h"),
    ("src/volsurf/views/charts.cpp", "volsurf/plot/chart.h"),
    ("src/volsurf/plot/canvas.cpp", "cairo-svg.h"),
    ("src/volsurf/pipeline/run.cpp", "volsurf/topology/hierarchy.h"),
    ("apps/volsurf/main.cpp", "CLI/CLI.hpp"),
    ("src/volsurf/core/grid.cpp", "vector"),
)


def check(folder):
    """The exit code and the lines of the checker."""
    script = REPOSITORY / "scripts" / "check_includes.py"
    run = subprocess.run([sys.executable, script, folder], capture_output=True, text=True, check=False)
    return run.returncode, run.stdout.splitlines()


def check_one_include(place, included):
    """The same for a tree of one file with one include."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "src" / "volsurf").mkdir(parents=True)
        path = Path(folder) / place
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"#pragma once\n\n#include <{included}>\n", encoding="utf-8")
        return check(folder)


class IncludeRule(unittest.TestCase):
    """One direction: core <- interop <- stages <- pipeline <- apps."""

    def test_this_repository_keeps_it(self):
        self.assertEqual(check(REPOSITORY), (0, []))

    def test_each_violation_is_named_with_its_line(self):
        for place, included in VIOLATIONS:
            with self.subTest(place=place, included=included):
                code, lines = check_one_include(place, included)
                self.assertEqual(code, 1)
                self.assertEqual(len(lines), 1)
                self.assertTrue(lines[0].startswith(f"{place}:3: "), lines[0])

    def test_what_is_allowed_passes(self):
        for place, included in KEPT:
            with self.subTest(place=place, included=included):
                self.assertEqual(check_one_include(place, included), (0, []))


if __name__ == "__main__":
    unittest.main()
