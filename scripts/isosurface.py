#!/usr/bin/python3
"""The largest parts of a scan's isosurface by VTK: what scripts/study.py sets beside volsurf.

In:  a scan that volsurf-phantom wrote (.nrrd), and a level, or `otsu` for the one that parts its histogram best (Otsu,
     "A threshold selection method from gray-level histograms", IEEE Trans. SMC 9, 1979).
Out: the largest connected parts of the isosurface, closed where the scan's border cuts it, as .vtp in LPS. Exit code 4
     where there is none.
"""

import argparse
import sys

from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkPolyDataConnectivityFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkImagingCore import vtkImageConstantPad
from vtkmodules.vtkImagingStatistics import vtkImageAccumulate
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from render import read_volume

BINS = 256


def otsu_level(image):
    """Between the two classes of samples whose means are furthest apart."""
    low, high = image.GetScalarRange()
    histogram = vtkImageAccumulate()
    histogram.SetInputData(image)
    histogram.SetComponentExtent(0, BINS - 1, 0, 0, 0, 0)
    histogram.SetComponentOrigin(low, 0, 0)
    histogram.SetComponentSpacing((high - low) / BINS, 0, 0)
    histogram.Update()
    counts = [histogram.GetOutput().GetScalarComponentAsDouble(index, 0, 0, 0) for index in range(BINS)]
    whole, moment = sum(counts), sum(index * count for index, count in enumerate(counts))
    best, best_index, below, moment_below = -1, 0, 0, 0
    for index, count in enumerate(counts[:-1]):
        below += count
        moment_below += index * count
        if 0 < below < whole:
            between = (moment * below - moment_below * whole) ** 2 / (below * (whole - below))
            if between > best:
                best, best_index = between, index
    return low + (high - low) * (best_index + 1) / BINS


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
    transform = vtkTransform()
    transform.SetMatrix(matrix)
    moved = vtkTransformPolyDataFilter()
    moved.SetInputConnection(largest.GetOutputPort())
    moved.SetTransform(transform)
    moved.Update()
    return moved.GetOutput()


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


def main(words):
    """Returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("scan")
    parser.add_argument("--level", required=True, help="an intensity, or otsu")
    parser.add_argument("--keep", type=int, default=1, help="how many parts")
    parser.add_argument("-o", "--output", required=True)
    arguments = parser.parse_args(words)
    image, matrix = read_volume(arguments.scan)
    level = otsu_level(image) if arguments.level == "otsu" else float(arguments.level)
    surface = largest_isosurfaces(image, matrix, level, arguments.keep)
    if surface.GetNumberOfCells() == 0:
        print(f"isosurface.py: there is no isosurface at {level:g}", file=sys.stderr)
        return 4
    return 0 if write(surface, arguments.output) else 5


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
