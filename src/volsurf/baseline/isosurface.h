// The surface where the interpolated volume has one value.
//
// Source: Lorensen and Cline, "Marching cubes", SIGGRAPH 1987, by vtkMarchingCubes; Schroeder, Maynard, Geveci, "Flying
// edges", LDAV 2015, by vtkFlyingEdges3D.
#pragma once

#include "volsurf/core/mesh.h"
#include "volsurf/core/volume.h"

namespace volsurf {

enum class IsosurfaceFilter { flying_edges, marching_cubes };

/// As VTK makes it, in world coordinates: open where it meets the border of the volume, with flat triangles where
/// samples have just this value. Normals point to lower values, out of what is bright. Without the arrays of a mesh.
/// O(samples).
Mesh isosurface(const Volume &volume, double iso, IsosurfaceFilter filter = IsosurfaceFilter::flying_edges);

} // namespace volsurf
