#!/usr/bin/python3
"""Labels of a real scan that scripts/study.py measures surfaces against.

In:  a scan without noise (.nrrd, .nhdr, .nii, .nii.gz).
Out: 1 in the chosen part of it and 0 elsewhere, as .nrrd on the same grid. On standard output, how it was chosen.

The part is what is above 0; or, of that, with --class-of 3, the brightest of so many classes of intensity by k-means in
one dimension (Lloyd, "Least squares quantization in PCM", IEEE Trans. Information Theory 28, 1982), its largest part that
hangs together over faces.
"""

import argparse
import gzip
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingMorphological import vtkImageConnectivityFilter

from render import read_volume

ROUNDS = 200


def class_means(values, count):
    """The means of classes of intensity, ascending."""
    means = numpy.quantile(values, (numpy.arange(count) + 0.5) / count)
    for _ in range(ROUNDS):
        nearest = numpy.searchsorted((means[1:] + means[:-1]) / 2, values)
        moved = numpy.array([values[nearest == index].mean() for index in range(count)])
        if numpy.allclose(moved, means):
            break
        means = moved
    return means


def largest_part(mask, size):
    """Of a mask in VTK's order of samples."""
    image = vtkImageData()
    image.SetDimensions(*size)
    image.GetPointData().SetScalars(numpy_to_vtk(mask, deep=True, array_type=VTK_UNSIGNED_CHAR))
    parts = vtkImageConnectivityFilter()
    parts.SetInputData(image)
    parts.SetScalarRange(1, 1)
    parts.SetExtractionModeToLargestRegion()
    parts.SetLabelModeToConstantValue()
    parts.SetLabelConstantValue(1)
    parts.Update()
    return (vtk_to_numpy(parts.GetOutput().GetPointData().GetScalars()) > 0).astype(numpy.uint8)


def write(mask, size, matrix, path):
    """As a NRRD in LPS."""
    def column(index):
        return "(" + ",".join(repr(matrix.GetElement(row, index)) for row in range(3)) + ")"

    header = ["NRRD0004", "type: uint8", "dimension: 3", "space: left-posterior-superior",
              "sizes: " + " ".join(map(str, size)), "space directions: " + " ".join(map(column, range(3))),
              "space origin: " + column(3), "kinds: domain domain domain", "endian: little", "encoding: gzip", "", ""]
    with open(path, "wb") as file:
        file.write("\n".join(header).encode("ascii"))
        file.write(gzip.compress(mask.tobytes(), compresslevel=1, mtime=0))


def main(words):
    """Returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("scan")
    parser.add_argument("--class-of", type=int, metavar="COUNT", help="the brightest of so many classes")
    parser.add_argument("-o", "--output", required=True)
    arguments = parser.parse_args(words)
    image, matrix = read_volume(arguments.scan)
    values = vtk_to_numpy(image.GetPointData().GetScalars()).astype(numpy.float64)
    mask = (values > 0).astype(numpy.uint8)
    if arguments.class_of:
        means = class_means(values[values > 0], arguments.class_of)
        level = (means[-1] + means[-2]) / 2
        mask = largest_part((values > level).astype(numpy.uint8), image.GetDimensions())
        print(f"above {level:.1f}, between classes of means {', '.join(f'{mean:.1f}' for mean in means)}")
    write(mask, image.GetDimensions(), matrix, arguments.output)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
