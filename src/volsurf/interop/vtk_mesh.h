// Mesh to vtkPolyData and back. Points keep their number and order: nothing is merged or dropped.
#pragma once

#include "volsurf/core/grid.h"
#include "volsurf/core/mesh.h"
#include "volsurf/interop/frame.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace volsurf {

/// The points (float32, given in `frame`) and triangles of a mesh, as a copy, without its arrays.
vtkSmartPointer<vtkPolyData> to_poly_data(const Mesh &mesh, Frame frame = Frame::lps);

/// Adds the mesh's arrays to the cells: RegionA, RegionB, Component (unsigned int), Persistence (float), Cap (unsigned
/// char). Empty arrays are left out.
void add_cell_arrays(const Mesh &mesh, vtkPolyData &data);

/// Moves the mesh's points to those of `data`, which must hold as many of them, in LPS.
void copy_points(vtkPolyData &data, Mesh &mesh);

/// A mesh of the points, triangles and known cell arrays of `data`. Throws InputError where a polygon is not a
/// triangle.
Mesh from_poly_data(vtkPolyData &data);

/// The same of a surface that a filter made in the index space of a grid: in world coordinates, and with the side to
/// which its triangles face kept where the grid is mirrored.
Mesh from_index_space(vtkPolyData &data, const Grid &grid);

} // namespace volsurf
