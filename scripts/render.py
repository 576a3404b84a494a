#!/usr/bin/python3
"""Draws surfaces into a PNG, off the screen, with VTK's Python (Debian: python3-vtk9, xvfb, xauth).

In:  one or more .vtp files as volsurf writes them (LPS millimetres, arrays with one entry per triangle or
     point) and, by choice, the scan that they come from (.nrrd, .nhdr, .nii, .nii.gz).
Out: one PNG, the surfaces side by side. With a scan, its slice through their middle is drawn too, and the line in
     which each surface meets it. Where there is no display the program starts itself again under xvfb-run.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
from itertools import product, zip_longest
from pathlib import Path

# Module by module: all of VTK at once replaces vtkNrrdReader by one that needs MPI.
import vtkmodules.vtkRenderingFreeType  # noqa: F401  draws text
from vtkmodules.vtkCommonCore import (
    VTK_DOUBLE,
    VTK_FLOAT,
    VTK_SHORT,
    VTK_UNSIGNED_CHAR,
    VTK_UNSIGNED_SHORT,
    vtkLookupTable,
)
from vtkmodules.vtkCommonDataModel import vtkBoundingBox, vtkDataObject, vtkPlane
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import (
    vtkClipPolyData,
    vtkCutter,
    vtkImageAppend,
    vtkPointDataToCellData,
    vtkPolyDataNormals,
    vtkThreshold,
)
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkImageReader2, vtkNIFTIImageReader, vtkNrrdReader, vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkImagingCore import vtkImageChangeInformation, vtkImageShrink3D
from vtkmodules.vtkImagingStatistics import vtkImageHistogramStatistics
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkImageSlice,
    vtkImageSliceMapper,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderWindow,
    vtkRenderer,
    vtkTextActor,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkSSAOPass

# Of a viewer who looks at a patient: the direction from the patient to the viewer, and up, in LPS.
VIEWS = {
    "anterior": ((0, -1, 0), (0, 0, 1)),
    "posterior": ((0, 1, 0), (0, 0, 1)),
    "left": ((1, 0, 0), (0, 0, 1)),
    "right": ((-1, 0, 0), (0, 0, 1)),
    "superior": ((0, 0, 1), (0, -1, 0)),
    "inferior": ((0, 0, -1), (0, -1, 0)),
    "three-quarter": ((0.8, -1, 0.45), (0, 0, 1)),
    "three-quarter-back": ((0.8, 1, 0.45), (0, 0, 1)),
}
HALVES = {name: VIEWS[name][0] for name in VIEWS if not name.startswith("three")}
PLAIN_COLOURS = {"bone": (0.97, 0.94, 0.86), "skin": (0.98, 0.82, 0.72), "brain": (0.96, 0.79, 0.76)}
LABEL_COLOURS = "#e0b3ab #74a9cc #edcd7b #8fbf8f #b79fcc #db8f6b #8cc7c2 #ccb894 #c7809e #9ea8b3".split()
GRADED_COLOURS = "#3b2f63 #3f5f8f #3f8f95 #6dbb80 #c9d56a #fbe88a".split()
RAW_TYPES = {
    "uint8": VTK_UNSIGNED_CHAR,
    "int16": VTK_SHORT,
    "uint16": VTK_UNSIGNED_SHORT,
    "float": VTK_FLOAT,
    "double": VTK_DOUBLE,
}
SUPERSAMPLING = 2  # pixels drawn per pixel of the picture, on each axis
BACKGROUND = (0.96, 0.96, 0.95)
INK = (0.20, 0.20, 0.22)
LINE_COLOUR = (0.95, 0.35, 0.20)


def parse_arguments(words):
    """Reads the command line."""
    parser = argparse.ArgumentParser(description="Draws surfaces of volsurf into a PNG, side by side.")
    parser.add_argument("surfaces", nargs="+", metavar="SURFACE.vtp")
    parser.add_argument("--png", required=True, help="the picture to write")
    parser.add_argument("--volume", help="the scan (.nrrd, .nhdr, .nii, .nii.gz): draws its middle slice too")
    parser.add_argument("--view", choices=VIEWS, default="three-quarter", help="default: three-quarter")
    parser.add_argument(
        "--color",
        default="none",
        help="Persistence, Component, RegionA, RegionB, Cap or another array of the triangles or points; none (default)",
    )
    parser.add_argument(
        "--thresholds",
        nargs="+",
        type=float,
        metavar="D",
        help="draws each surface once per number: its triangles with a Persistence of at least D",
    )
    parser.add_argument("--range", metavar="LOW,HIGH", help="of the colours; default: 2nd to 98th percentile")
    parser.add_argument("--plain", choices=PLAIN_COLOURS, default="bone", help="the colour with --color none")
    parser.add_argument("--opacity", type=float, default=1.0, help="of the surfaces, 0 to 1 (default)")
    parser.add_argument("--clip", choices=HALVES, help="cut this half away, to look inside")
    parser.add_argument("--captions", nargs="+", default=[], metavar="TEXT", help="one per part of the picture")
    parser.add_argument("--together", action="store_true", help="one scale and place for all, instead of each fitted")
    parser.add_argument("--zoom", type=float, default=1.0)
    parser.add_argument("--size", default="900x700", help="WIDTHxHEIGHT of each surface's part (default: 900x700)")
    arguments = parser.parse_args(words)
    parts = len(arguments.surfaces) * len(arguments.thresholds or [0])
    if arguments.captions and len(arguments.captions) != parts:
        parser.error(f"--captions needs one text per part of the picture, of which there are {parts}")
    arguments.size = numbers_of(parser, "--size", arguments.size, r"(\d+)x(\d+)", int)
    if arguments.range:
        arguments.range = numbers_of(parser, "--range", arguments.range, r"([^,]+),([^,]+)", float)
    return arguments


def numbers_of(parser, option, text, pattern, kind):
    """The numbers in an option's text."""
    match = re.fullmatch(pattern, text)
    try:
        return tuple(kind(number) for number in match.groups())
    except (AttributeError, ValueError):
        return parser.error(f"{option}: cannot read '{text}'")


def fail(message):
    """Ends the program with one line."""
    sys.exit(f"render.py: {message}")


def run_on_virtual_display(words):
    """Runs this program again under xvfb-run, as Debian's VTK draws on an X display. Returns its exit code."""
    if not shutil.which("xvfb-run"):
        fail("there is no display and no xvfb-run: install xvfb and xauth")
    return subprocess.call(["xvfb-run", "-a", sys.executable, __file__, *words])


# --- Reading


def existing(path):
    """The path, if there is such a file."""
    if not Path(path).is_file():
        fail(f"{path}: there is no such file")
    return path


def by_triangle(surface):
    """The surface with the arrays of its points, such as a distance, as means over each triangle too."""
    averages = vtkPointDataToCellData()
    averages.SetInputData(surface)
    averages.PassPointDataOff()
    averages.Update()
    return averages.GetOutput()


def read_surface(path, colour_array):
    """A .vtp file as vtkPolyData that has triangles and the array to colour by."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(existing(path))
    reader.Update()
    surface = reader.GetOutput()
    if surface.GetNumberOfPolys() == 0:
        fail(f"{path}: holds no triangles")
    if surface.GetPointData().HasArray(colour_array):
        surface = by_triangle(surface)
    if colour_array != "none" and not surface.GetCellData().HasArray(colour_array):
        fail(f"{path}: has no array '{colour_array}' for its triangles")
    return in_lps(surface)


def above_threshold(surface, delta):
    """The triangles of a surface that stay up to this delta."""
    threshold = vtkThreshold()
    threshold.SetInputData(surface)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "Persistence")
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    threshold.SetUpperThreshold(delta)
    polygons = vtkGeometryFilter()
    polygons.SetInputConnection(threshold.GetOutputPort())
    polygons.Update()
    if polygons.GetOutput().GetNumberOfPolys() == 0:
        fail(f"--thresholds: no triangle stays up to {delta:g}")
    return polygons.GetOutput()


def in_lps(surface):
    """The surface in LPS; volsurf says in the field SPACE where it wrote RAS."""
    space = surface.GetFieldData().GetAbstractArray("SPACE")
    if not space or space.GetValue(0) != "RAS":
        return surface
    half_turn = vtkTransform()
    half_turn.RotateZ(180)
    turned = vtkTransformPolyDataFilter()
    turned.SetTransform(half_turn)
    turned.SetInputData(surface)
    turned.Update()
    return turned.GetOutput()


def read_volume(path):
    """A scan, on a grid of spacing 1 from 0, and the matrix that takes its indices to LPS millimetres."""
    if path.endswith((".nrrd", ".nhdr")):
        fields = nrrd_fields(existing(path))
        reader = nrrd_reader(path, fields)
        matrix = nrrd_matrix(fields)
    elif path.endswith((".nii", ".nii.gz")):
        reader = vtkNIFTIImageReader()
        reader.SetFileName(existing(path))
        reader.Update()
        matrix = nifti_matrix(reader)
    else:
        fail(f"{path}: is not a .nrrd, .nhdr, .nii or .nii.gz file")
    on_indices = vtkImageChangeInformation()
    on_indices.SetInputConnection(reader.GetOutputPort())
    on_indices.SetOutputSpacing(1, 1, 1)
    on_indices.SetOutputOrigin(0, 0, 0)
    on_indices.Update()
    if not on_indices.GetOutput().GetPointData().GetScalars():
        fail(f"{path}: cannot be read by VTK")
    return on_indices.GetOutput(), matrix


def affine(axes, origin, signs):
    """A vtkMatrix4x4 of three axis vectors and an origin, with each row times its sign."""
    matrix = vtkMatrix4x4()
    for row in range(3):
        for column in range(3):
            matrix.SetElement(row, column, signs[row] * axes[column][row])
        matrix.SetElement(row, 3, signs[row] * origin[row])
    return matrix


def nrrd_fields(path):
    """The fields of a NRRD header by name, as text."""
    fields = {}
    with open(path, "rb") as file:
        for line in iter(file.readline, b""):
            text = line.decode("latin-1").strip()
            if not text:
                break
            name, _, value = text.partition(": ")
            fields[name] = value
    return fields


def vectors(text):
    """The vectors in a NRRD field, '(1,0,0) (0,1,0) (0,0,1)'."""
    return [[float(number) for number in vector.split(",")] for vector in re.findall(r"\(([^)]*)\)", text)]


def nrrd_reader(path, fields):
    """vtkNrrdReader, or a plain one for what it cannot do: raw data behind the header of another format."""
    skip = int(fields.get("byte skip", 0))
    if skip == 0:
        reader = vtkNrrdReader()
        reader.SetFileName(path)
        return reader
    if fields["encoding"] != "raw" or fields["type"] not in RAW_TYPES or "data file" not in fields:
        fail(f"{path}: with a byte skip, only raw data of a simple type in a file of their own can be read")
    reader = vtkImageReader2()
    reader.SetFileName(existing(str(Path(path).parent / fields["data file"])))
    reader.SetHeaderSize(skip)
    reader.FileLowerLeftOn()
    reader.SetFileDimensionality(3)
    reader.SetDataExtent(*(bound for size in fields["sizes"].split() for bound in (0, int(size) - 1)))
    reader.SetDataScalarType(RAW_TYPES[fields["type"]])
    reader.SetDataByteOrder(1 if fields.get("endian") == "little" else 0)
    return reader


def nrrd_matrix(fields):
    """Index to LPS millimetres, from the header's fields, because vtkNrrdReader keeps no directions."""
    axes = vectors(fields.get("space directions", ""))
    if len(axes) != 3:
        spacing = [float(word) for word in fields.get("spacings", "1 1 1").split()]
        axes = [[spacing[0], 0, 0], [0, spacing[1], 0], [0, 0, spacing[2]]]
    space = fields.get("space", "left-posterior-superior").upper()
    first, second = (word[0] for word in space.split("-")[:2]) if "-" in space else space[:2]
    signs = (-1 if first == "R" else 1, -1 if second == "A" else 1, 1)
    return affine(axes, vectors(fields.get("space origin", "(0,0,0)"))[0], signs)


def nifti_matrix(reader):
    """Index to LPS millimetres; NIfTI itself says them in RAS, and VTK gives its axes without their lengths."""
    matrix = reader.GetQFormMatrix() or reader.GetSFormMatrix() or vtkMatrix4x4()
    spacing = reader.GetDataSpacing()
    axes = [[matrix.GetElement(row, column) for row in range(3)] for column in range(3)]
    lengths = [sum(number * number for number in axis) ** 0.5 for axis in axes]
    axes = [[number * mm / length for number in axis] for axis, mm, length in zip(axes, spacing, lengths)]
    return affine(axes, [matrix.GetElement(row, 3) for row in range(3)], (-1, -1, 1))


# --- Colours


def rgb(code):
    """'#ff8000' as three numbers from 0 to 1."""
    return tuple(int(code[start : start + 2], 16) / 255 for start in (1, 3, 5))


def colour_range(surfaces, name, part=0.02):
    """The range of an array over all surfaces, without the extreme parts at both ends."""
    values = []
    for surface in surfaces:
        array = surface.GetCellData().GetArray(name)
        step = array.GetNumberOfTuples() // 100000 + 1
        values += [array.GetTuple1(index) for index in range(0, array.GetNumberOfTuples(), step)]
    values.sort()
    return values[int(part * (len(values) - 1))], values[int((1 - part) * (len(values) - 1))]


def graded_colours(low, high):
    """From dark to light, over a range."""
    colours = vtkColorTransferFunction()
    for index, code in enumerate(GRADED_COLOURS):
        colours.AddRGBPoint(low + (high - low) * index / (len(GRADED_COLOURS) - 1), *rgb(code))
    return colours


def label_colours(surfaces, name):
    """One of ten colours for each label from 1 on, grey for 0."""
    highest = max(int(surface.GetCellData().GetArray(name).GetRange()[1]) for surface in surfaces)
    colours = vtkLookupTable()
    colours.SetNumberOfTableValues(highest + 1)
    colours.SetTableRange(-0.5, highest + 0.5)
    colours.SetTableValue(0, 0.7, 0.7, 0.7, 1)
    for label in range(1, highest + 1):
        colours.SetTableValue(label, *rgb(LABEL_COLOURS[(label - 1) % len(LABEL_COLOURS)]), 1)
    return colours


def colours_for(surfaces, arguments):
    """The colour map for --color: graded for measures, one colour each for ids."""
    if arguments.color == "none":
        return None
    array = surfaces[0].GetCellData().GetArray(arguments.color)
    if array.GetDataType() in (VTK_FLOAT, VTK_DOUBLE):
        return graded_colours(*(arguments.range or colour_range(surfaces, arguments.color)))
    return label_colours(surfaces, arguments.color)


# --- What is drawn


def surface_actor(surface, plane, colours, arguments):
    """The surface with smooth shading, cut by the plane if there is one."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SplittingOff()
    normals.ConsistencyOff()
    source = normals
    if plane:
        source = vtkClipPolyData()
        source.SetInputConnection(normals.GetOutputPort())
        source.SetClipFunction(plane)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.SetScalarVisibility(colours is not None)
    if colours:
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray(arguments.color)
        mapper.SetLookupTable(colours)
        mapper.UseLookupTableScalarRangeOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    shine(actor.GetProperty(), PLAIN_COLOURS[arguments.plain], arguments.opacity)
    return actor


def shine(look, colour, opacity):
    """A soft, slightly glossy material."""
    look.SetColor(*colour)
    look.SetOpacity(opacity)
    look.SetAmbient(0.12)
    look.SetDiffuse(0.85)
    look.SetSpecular(0.15)
    look.SetSpecularPower(25)


def plane_through(point, normal):
    """A vtkPlane."""
    plane = vtkPlane()
    plane.SetOrigin(*point)
    plane.SetNormal(*normal)
    return plane


def line_actor(surface, plane):
    """The line in which a surface meets a plane."""
    cutter = vtkCutter()
    cutter.SetInputData(surface)
    cutter.SetCutFunction(plane)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(cutter.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*LINE_COLOUR)
    actor.GetProperty().SetLineWidth(2 * SUPERSAMPLING)
    actor.GetProperty().LightingOff()
    return actor


def slice_place(volume, matrix, centre, normal):
    """The slice through the centre, across the scan's own axis that is nearest to the normal: its axis and index."""
    axis = max(range(3), key=lambda column: cosine(matrix, column, normal))
    inverse = vtkMatrix4x4()
    vtkMatrix4x4.Invert(matrix, inverse)
    index = round(inverse.MultiplyPoint((*centre, 1))[axis])
    return axis, min(max(index, 0), volume.GetDimensions()[axis] - 1)


def slice_corners(volume, matrix, axis, index):
    """The corners of a slice, in the world."""
    ranges = [(0, size - 1) for size in volume.GetDimensions()]
    ranges[axis] = (index,)
    return [matrix.MultiplyPoint((*corner, 1))[:3] for corner in product(*ranges)]


def slice_actor(volume, matrix, axis, index):
    """A slice of the scan, in grey."""
    mapper = vtkImageSliceMapper()
    mapper.SetInputData(volume)
    mapper.SetOrientation(axis)
    mapper.SetSliceNumber(index)
    actor = vtkImageSlice()
    actor.SetMapper(mapper)
    actor.SetUserMatrix(matrix)
    low, high = grey_range(volume)
    actor.GetProperty().SetColorWindow(high - low)
    actor.GetProperty().SetColorLevel((high + low) / 2)
    return actor


def cosine(matrix, column, normal):
    """Between a matrix's column and a direction, without its sign."""
    vector = [matrix.GetElement(row, column) for row in range(3)]
    length = sum(number * number for number in vector) ** 0.5
    return abs(sum(a * b for a, b in zip(vector, normal))) / length


def grey_range(volume):
    """From black to white: the whole range but its uppermost 1 % of samples."""
    histogram = vtkImageHistogramStatistics()
    histogram.SetInputData(volume)
    histogram.SetAutoRangePercentiles(0, 99)
    histogram.SetAutoRangeExpansionFactors(0, 0)
    histogram.Update()
    return histogram.GetAutoRange()


def legend(colours, name):
    """A horizontal scale at the bottom."""
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colours)
    bar.SetTitle(f"{name} (intensity / mm)" if name == "Persistence" else name)
    bar.SetOrientationToHorizontal()
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%-#.3g")
    bar.UnconstrainedFontSizeOn()
    bar.SetTextPositionToPrecedeScalarBar()
    bar.SetPosition(0.25, 0.025)
    bar.SetWidth(0.5)
    bar.SetHeight(0.11)
    for text, size in ((bar.GetTitleTextProperty(), 17), (bar.GetLabelTextProperty(), 15)):
        plain_text(text, size)
    return bar


def plain_text(text, size):
    """Upright, dark, without a shadow."""
    text.SetColor(*INK)
    text.SetFontSize(SUPERSAMPLING * size)
    text.BoldOff()
    text.ItalicOff()
    text.ShadowOff()


def caption(text):
    """A line of text at the top."""
    actor = vtkTextActor()
    actor.SetInput(text)
    plain_text(actor.GetTextProperty(), 20)
    actor.GetTextProperty().SetJustificationToCentered()
    actor.GetTextProperty().SetVerticalJustificationToTop()
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(0.5, 0.975)
    return actor


# --- The picture


def box_of(surfaces):
    """The bounds of all surfaces."""
    box = vtkBoundingBox()
    for surface in surfaces:
        box.AddBounds(surface.GetBounds())
    bounds = [0] * 6
    box.GetBounds(bounds)
    return bounds


def centre_of(bounds):
    """The centre of bounds."""
    return [(bounds[2 * axis] + bounds[2 * axis + 1]) / 2 for axis in range(3)]


def aim(renderer, points, arguments, has_legend):
    """Points a parallel camera so that the points fill the renderer, between the caption and the legend."""
    towards_viewer, up = VIEWS[arguments.view]
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*towards_viewer)
    camera.SetViewUp(*up)
    left, right, low, high, near = seen_extent(camera, points)
    bottom, top = 0.17 if has_legend else 0.04, 0.92 if arguments.captions else 0.96
    width, height = arguments.size
    scale = max((high - low) / (top - bottom), (right - left) / 0.94 * height / width) / 2 / arguments.zoom
    shift = (1 - top - bottom) * scale
    # No further away than need be: ambient occlusion knows depths in few digits, and would draw them as rings.
    move_to(camera, ((left + right) / 2, (low + high) / 2 + shift), near + 3 * scale)
    camera.SetParallelScale(scale)
    renderer.ResetCameraClippingRange()


def sample_of_points(surfaces):
    """Some of the points of the surfaces, evenly taken."""
    for surface in surfaces:
        step = surface.GetNumberOfPoints() // 20000 + 1
        yield from (surface.GetPoint(index) for index in range(0, surface.GetNumberOfPoints(), step))


def seen_extent(camera, points):
    """Left, right, low and high of points as the camera sees them, and how near to the viewer they come."""
    view = camera.GetViewTransformMatrix()
    seen = [view.MultiplyPoint((*point, 1)) for point in points]
    across, upward, towards = ([point[axis] for point in seen] for axis in range(3))
    return min(across), max(across), min(upward), max(upward), max(towards)


def move_to(camera, middle, forward):
    """Moves a camera along its own axes, so that what it sees at (across, upward) is in its middle."""
    view = camera.GetViewTransformMatrix()
    move = [sum(way * view.GetElement(row, axis) for row, way in enumerate((*middle, forward))) for axis in range(3)]
    camera.SetFocalPoint(*(start + offset for start, offset in zip(camera.GetFocalPoint(), move)))
    camera.SetPosition(*(start + offset for start, offset in zip(camera.GetPosition(), move)))


def shade_crevices(renderer, bounds):
    """Darkens folds and hollows (ambient occlusion), so that depth is seen without shadows."""
    diagonal = sum((bounds[2 * axis + 1] - bounds[2 * axis]) ** 2 for axis in range(3)) ** 0.5
    occlusion = vtkSSAOPass()
    occlusion.SetRadius(0.05 * diagonal)
    occlusion.SetBias(0.002 * diagonal)
    occlusion.SetKernelSize(128)
    occlusion.BlurOn()
    occlusion.SetDelegatePass(vtkRenderStepsPass())
    renderer.SetPass(occlusion)


def renderer_of(surface, others, colours, scan, arguments):
    """A renderer with one surface, placed by it alone or by the others too."""
    renderer = vtkRenderer()
    renderer.SetBackground(*BACKGROUND)
    lights = vtkLightKit()
    lights.SetKeyLightIntensity(0.95)
    lights.AddLightsToRenderer(renderer)
    placed = others if arguments.together else [surface]
    centre = centre_of(box_of(placed))
    half = HALVES.get(arguments.clip)
    inward = plane_through(centre, [-number for number in half]) if half else None
    renderer.AddActor(surface_actor(surface, inward, colours, arguments))
    points = [point for point in sample_of_points(placed) if not inward or inward.EvaluateFunction(point) >= 0]
    if scan:
        across = half or VIEWS[arguments.view][0]
        place = slice_place(*scan, centre, across)
        renderer.AddViewProp(slice_actor(*scan, *place))
        renderer.AddActor(line_actor(surface, plane_through(centre, across)))
        points += slice_corners(*scan, *place)
    elif arguments.opacity == 1:
        shade_crevices(renderer, box_of(placed))
    aim(renderer, points, arguments, has_legend=isinstance(colours, vtkColorTransferFunction))
    return renderer


def window_of(renderer, colours, text, arguments):
    """A window with one renderer, its legend where colours are graded, and its caption."""
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetSize(*(SUPERSAMPLING * length for length in arguments.size))
    window.AddRenderer(renderer)
    if isinstance(colours, vtkColorTransferFunction):
        renderer.AddViewProp(legend(colours, arguments.color))
    if text:
        renderer.AddViewProp(caption(text))
    return window


def images_of(surfaces, scan, arguments):
    """One image for each surface, from windows of their own: ambient occlusion needs a window to itself."""
    colours = colours_for(surfaces, arguments)
    for surface, text in zip_longest(surfaces, arguments.captions):
        renderer = renderer_of(surface, surfaces, colours, scan, arguments)
        yield image_of(window_of(renderer, colours, text, arguments))


def image_of(window):
    """What a window shows, each pixel the mean of those drawn for it."""
    window.Render()
    drawn = vtkWindowToImageFilter()
    drawn.SetInput(window)
    drawn.ReadFrontBufferOff()
    averaged = vtkImageShrink3D()
    averaged.SetInputConnection(drawn.GetOutputPort())
    averaged.SetShrinkFactors(SUPERSAMPLING, SUPERSAMPLING, 1)
    averaged.MeanOn()
    averaged.Update()
    return averaged.GetOutput()


def write_png(images, path):
    """Writes images side by side."""
    row = vtkImageAppend()
    for image in images:
        row.AddInputData(image)
    writer = vtkPNGWriter()
    writer.SetInputConnection(row.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()
    if writer.GetErrorCode():
        fail(f"{path}: cannot be written")


def main(words):
    """Returns the exit code."""
    arguments = parse_arguments(words)
    if not os.environ.get("DISPLAY"):
        return run_on_virtual_display(words)
    surfaces = [read_surface(path, arguments.color) for path in arguments.surfaces]
    if arguments.thresholds:
        surfaces = [above_threshold(surface, delta) for surface in surfaces for delta in arguments.thresholds]
    scan = read_volume(arguments.volume) if arguments.volume else None
    write_png(images_of(surfaces, scan, arguments), arguments.png)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
