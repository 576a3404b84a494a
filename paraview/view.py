"""Shows a surface of volsurf in ParaView 5.11 or newer, coloured by persistence, with slices of its scan.

In:  pvpython view.py SURFACE.vtp [--volume SCAN.nrrd] [--png PICTURE.png]
     or, inside the ParaView GUI (Tools > Python Shell > Run Script), the source that is selected in the Pipeline Browser.
Out: the view; the picture with --png.

ParaView's NRRD reader keeps the origin and the spacing of a scan but not its direction, so the slices are turned into
place by a Transform made from the header. Scans of other formats cannot be shown rightly: it has no reader for .nii.gz,
and drops the direction of .mha too.
"""

import argparse
import re
import sys
from pathlib import Path

from paraview import simple
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform

LEGEND_TITLE = "Persistence (intensity / mm)"
BACKGROUND = [0.96, 0.96, 0.95]
INK = [0.20, 0.20, 0.22]
NO_TURN = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]


def parse_arguments(words):
    """Reads the command line."""
    parser = argparse.ArgumentParser(prog="view.py", description="Shows a surface of volsurf in ParaView.")
    parser.add_argument("surface", nargs="?", help="a .vtp file; default: the active source")
    parser.add_argument("--volume", help="the scan it comes from (.nrrd, .nhdr)")
    parser.add_argument("--png", help="a picture to write")
    parser.add_argument("--size", type=int, nargs=2, default=[1000, 800], metavar=("WIDTH", "HEIGHT"))
    return parser.parse_args(words)


def fail(message):
    """Ends the script with one line on stderr."""
    sys.exit(f"view.py: {message}")


def warn(message):
    """One line on stderr."""
    print(f"view.py: {message}", file=sys.stderr)


# --- The surface


def open_surface(path):
    """The .vtp file, or the active source where there is no path."""
    if not path:
        return simple.GetActiveSource() or fail("name a .vtp file, or select a source in the Pipeline Browser")
    if not Path(path).is_file():
        fail(f"{path}: there is no such file")
    surface = simple.XMLPolyDataReader(FileName=[path])
    surface.UpdatePipeline()
    if surface.GetDataInformation().GetNumberOfCells() == 0:
        fail(f"{path}: ParaView reads no triangles from it")
    return surface


def frame_signs(surface):
    """What LPS coordinates are multiplied by to be in the surface's own frame: -1, -1, 1 where it was written as RAS."""
    space = simple.servermanager.Fetch(surface).GetFieldData().GetAbstractArray("SPACE")
    return (-1, -1, 1) if space and space.GetValue(0) == "RAS" else (1, 1, 1)


def show_surface(surface, view):
    """Smoothly shaded, coloured by persistence, with a legend."""
    make_normals = getattr(simple, "SurfaceNormals", None) or simple.GenerateSurfaceNormals
    normals = make_normals(Input=surface)
    normals.Splitting = 0
    normals.Consistency = 0
    simple.Hide(surface, view)
    display = simple.Show(normals, view)
    display.Representation = "Surface"
    if surface.CellData.GetArray("Persistence") is None:
        warn("the surface has no array 'Persistence', so that it is shown in one colour")
        return
    simple.ColorBy(display, ("CELLS", "Persistence"))
    colours = simple.GetColorTransferFunction("Persistence")
    colours.ApplyPreset("Viridis (matplotlib)", True)
    show_legend(colours, view)
    display.SetScalarBarVisibility(view, True)


def show_legend(colours, view):
    """The legend of a colour map, with units."""
    legend = simple.GetScalarBar(colours, view)
    legend.Title = LEGEND_TITLE
    legend.ComponentTitle = ""
    legend.TitleColor = INK
    legend.LabelColor = INK
    legend.Orientation = "Horizontal"
    legend.WindowLocation = "Lower Center"
    legend.ScalarBarLength = 0.4
    legend.TitleFontSize, legend.LabelFontSize = 18, 16
    legend.AutomaticLabelFormat = 0
    legend.LabelFormat = legend.RangeLabelFormat = "%.3g"


# --- The scan


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


def lps_signs(fields):
    """What a header's coordinates are multiplied by to be LPS."""
    space = fields.get("space", "left-posterior-superior").upper()
    first, second = (word[0] for word in space.split("-")[:2]) if "-" in space else space[:2]
    return (-1 if first == "R" else 1, -1 if second == "A" else 1, 1)


def unit_axes(fields):
    """The directions of the scan's axes in its header's space."""
    axes = vectors(fields.get("space directions", "")) or NO_TURN
    return [[number / sum(n * n for n in axis) ** 0.5 for number in axis] for axis in axes]


def open_volume(path):
    """The scan as ParaView reads it, and its header."""
    if not path.endswith((".nrrd", ".nhdr")):
        fail(f"{path}: ParaView places only .nrrd and .nhdr rightly, by this script")
    if not Path(path).is_file():
        fail(f"{path}: there is no such file")
    fields = nrrd_fields(path)
    if fields.get("byte skip", "0") != "0" or int(fields["sizes"].split()[0]) <= 9:
        fail(f"{path}: ParaView cannot read a NRRD with a byte skip, or whose first axis has less than ten samples")
    volume = simple.NrrdReader(FileName=path)
    volume.UpdatePipeline()
    return volume, fields


def into_place(volume, fields, signs):
    """The transform from where ParaView puts the scan to where it lies: position, rotation and scale."""
    to_frame = [a * b for a, b in zip(lps_signs(fields), signs)]
    axes = [[number * sign for number, sign in zip(axis, to_frame)] for axis in unit_axes(fields)]
    origin = [n * sign for n, sign in zip(vectors(fields.get("space origin", "(0,0,0)"))[0], to_frame)]
    read_origin = volume.GetDataInformation().GetBounds()[0::2]
    position = [origin[row] - sum(axes[k][row] * read_origin[k] for k in range(3)) for row in range(3)]
    mirror = -1 if determinant(axes) < 0 else 1
    rotation = vtkTransform()
    rotation.SetMatrix(matrix_of([[n * mirror for n in axes[0]], axes[1], axes[2]]))
    return position, list(rotation.GetOrientation()), [mirror, 1, 1]


def matrix_of(axes):
    """A vtkMatrix4x4 with these columns."""
    matrix = vtkMatrix4x4()
    for column, axis in enumerate(axes):
        for row in range(3):
            matrix.SetElement(row, column, axis[row])
    return matrix


def determinant(axes):
    """Of three vectors."""
    return matrix_of(axes).Determinant()


def show_slices(volume, place, front_to_back, view):
    """The middle slice across each axis, in grey, where the scan lies. Only the one from side to side is visible: the
    front of the surface is before it; the Pipeline Browser's eyes show the others."""
    extent = volume.GetDataInformation().GetExtent()
    position, rotation, scale = place
    for axis in range(3):
        middle = (extent[2 * axis] + extent[2 * axis + 1]) // 2
        cut = list(extent)
        cut[2 * axis : 2 * axis + 2] = [middle, middle]
        one_slice = simple.ExtractSubset(Input=volume, VOI=cut)
        placed = simple.Transform(Input=one_slice)
        placed.Transform.Translate = position
        placed.Transform.Rotate = rotation
        placed.Transform.Scale = scale
        show_grey(placed, volume, view)
        if axis != front_to_back:
            simple.Hide(placed, view)


def show_grey(source, volume, view):
    """A slice without shading, from black to white."""
    name = volume.PointData.GetArray(0).Name
    display = simple.Show(source, view)
    display.Representation = "Surface"
    display.Ambient, display.Diffuse = 1.0, 0.0
    simple.ColorBy(display, ("POINTS", name))
    simple.GetColorTransferFunction(name).ApplyPreset("Grayscale", True)
    display.SetScalarBarVisibility(view, False)


# --- The view


def aim(view, signs):
    """Looks at the patient from the front, the left and above, and fits all of it in."""
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraPosition = [0.8 * signs[0], -1.0 * signs[1], 0.45]
    view.CameraViewUp = [0, 0, 1]
    simple.ResetCamera(view)
    view.GetActiveCamera().Dolly(1.3)


def main(words):
    """Shows what is asked for."""
    arguments = parse_arguments(words)
    surface = open_surface(arguments.surface)
    signs = frame_signs(surface)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = BACKGROUND
    view.OrientationAxesLabelColor = INK
    view.ViewSize = arguments.size
    show_surface(surface, view)
    if arguments.volume:
        volume, fields = open_volume(arguments.volume)
        axes = unit_axes(fields)
        front_to_back = max(range(3), key=lambda axis: abs(axes[axis][1]))
        show_slices(volume, into_place(volume, fields, signs), front_to_back, view)
    aim(view, signs)
    simple.Render(view)
    if arguments.png:
        simple.SaveScreenshot(arguments.png, view, ImageResolution=arguments.size)


# In the GUI's shell the program's own words are ParaView's, not ours.
main(sys.argv[1:] if Path(sys.argv[0]).name == "view.py" else [])
