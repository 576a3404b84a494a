#!/usr/bin/python3
"""The largest parts of a scan's isosurface by VTK: what scripts/study.py sets beside volsurf.

In:  a scan that volsurf-phantom wrote (.nrrd), and a level, or `otsu` for the one that parts its histogram best (Otsu,
     "A threshold selection method from gray-level histograms", IEEE Trans. SMC 9, 1979), or `best` for the one whose
     surface is nearest to a true one, by the mean distance of points of both.
Out: the largest connected parts of the isosurface, closed where the scan's border cuts it, as .vtp in LPS; on standard
     output the level. Exit code 4 where there is none.
"""

import argparse
import math
import sys

from vtkmodules.vtkCommonCore import mutable, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFlyingEdges3D, vtkPolyDataConnectivityFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkImagingCore import vtkImageConstantPad
from vtkmodules.vtkImagingStatistics import vtkImageAccumulate
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from best_level import best_level
from render import read_surface, read_volume

BINS = 256
POINTS = 1500  # of each surface, for a mean distance


def otsu_level(image):
    """Between the two classes of samples whose means are furthest apart; in the middle of all such levels."""
    low, high = image.GetScalarRange()
    histogram = vtkImageAccumulate()
    histogram.SetInputData(image)
    histogram.SetComponentExtent(0, BINS - 1, 0, 0, 0, 0)
    histogram.SetComponentOrigin(low, 0, 0)
    histogram.SetComponentSpacing((high - low) / BINS, 0, 0)
    histogram.Update()
    counts = [histogram.GetOutput().GetScalarComponentAsDouble(index, 0, 0, 0) for index in range(BINS)]
    whole, moment = sum(counts), sum(index * count for index, count in enumerate(counts))
    best, first, last, below, moment_below = -1, 0, 0, 0, 0
    for index, count in enumerate(counts[:-1]):
        below += count
        moment_below += index * count
        if 0 < below < whole:
            between = (moment * below - moment_below * whole) ** 2 / (below * (whole - below))
            if between > best:
                best, first = between, index
            if between == best:
                last = index
    return low + (high - low) * ((first + last) / 2 + 1) / BINS


def padded(image):
    """With a layer of its darkest value around it, so that surfaces close."""
    extent = image.GetExtent()
    pad = vtkImageConstantPad()
    pad.SetInputData(image)
    pad.SetOutputWholeExtent(*(bound + (1 if index % 2 else -1) for index, bound in enumerate(extent)))
    pad.SetConstant(image.GetScalarRange()[0])
    pad.Update()
    return pad.GetOutput()


def largest_isosurfaces(image, matrix, level, count):
    """The parts with the most points, in the world."""
    surface = vtkFlyingEdges3D()
    surface.SetInputData(padded(image))
    surface.SetValue(0, level)
    surface.ComputeNormalsOff()
    surface.ComputeScalarsOff()
    largest = vtkPolyDataConnectivityFilter()
    largest.SetInputConnection(surface.GetOutputPort())
    largest.SetExtractionModeToAllRegions()
    largest.Update()
    sizes = largest.GetRegionSizes()
    parts = sorted(range(largest.GetNumberOfExtractedRegions()), key=sizes.GetValue, reverse=True)
    largest.SetExtractionModeToSpecifiedRegions()
    for part in parts[:count]:
        largest.AddSpecifiedRegion(part)
    used_points = vtkCleanPolyData()
    used_points.SetInputConnection(largest.GetOutputPort())
    used_points.PointMergingOff()
    transform = vtkTransform()
    transform.SetMatrix(matrix)
    moved = vtkTransformPolyDataFilter()
    moved.SetInputConnection(used_points.GetOutputPort())
    moved.SetTransform(transform)
    moved.Update()
    return moved.GetOutput()


class Truth:
    """A surface to be near to."""

    def __init__(self, surface):
        self.surface, self.locator = surface, locator_of(surface)

    def mean_distance(self, surface):
        """Over points of both, infinite from an empty surface."""
        if surface.GetNumberOfCells() == 0:
            return math.inf
        return (mean_distance(surface, self.locator) + mean_distance(self.surface, locator_of(surface))) / 2


def locator_of(surface):
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    return locator


def mean_distance(surface, locator):
    """Of at most POINTS vertices, evenly from the list of all."""
    count = surface.GetNumberOfPoints()
    chosen = range(0, count, max(1, count // POINTS))
    nearest, cell, part, squared = [0.0, 0.0, 0.0], mutable(0), mutable(0), mutable(0.0)
    total = 0.0
    for index in chosen:
        locator.FindClosestPoint(surface.GetPoint(index), nearest, cell, part, squared)
        total += math.sqrt(squared.get())
    return total / len(chosen)


def write(surface, path):
    """With the frame, as volsurf says it."""
    frame = vtkStringArray()
    frame.SetName("SPACE")
    frame.InsertNextValue("LPS")
    surface.GetFieldData().AddArray(frame)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(surface)
    writer.SetFileName(path)
    return writer.Write() == 1


def parse_arguments(words):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("scan")
    parser.add_argument("--level", required=True, help="an intensity, otsu or best")
    parser.add_argument("--truth", metavar="SURFACE.vtp", help="what the best level is near to")
    parser.add_argument("--between", nargs=2, type=float, metavar=("LOW", "HIGH"), help="where the best level is sought")
    parser.add_argument("--keep", type=int, default=1, help="how many parts")
    parser.add_argument("-o", "--output", required=True)
    arguments = parser.parse_args(words)
    if arguments.level == "best" and not (arguments.truth and arguments.between):
        parser.error("--level best needs --truth and --between")
    return arguments


def main(words):
    """Returns the exit code."""
    arguments = parse_arguments(words)
    image, matrix = read_volume(arguments.scan)

    def surface_at(level):
        return largest_isosurfaces(image, matrix, level, arguments.keep)

    if arguments.level == "otsu":
        level = otsu_level(image)
    elif arguments.level == "best":
        truth = Truth(read_surface(arguments.truth, "none"))
        level = best_level(lambda tried: truth.mean_distance(surface_at(tried)), *arguments.between)
    else:
        level = float(arguments.level)
    surface = surface_at(level)
    if surface.GetNumberOfCells() == 0:
        print(f"isosurface.py: there is no isosurface at {level:g}", file=sys.stderr)
        return 4
    print(f"{level:g}")
    return 0 if write(surface, arguments.output) else 5


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
