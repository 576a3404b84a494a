// The samples that a surface encloses.
#pragma once

#include "volsurf/compare/mask.h"

namespace volsurf {

/// The samples of the grid that a closed surface winds round, whichever way its normals point. A sample exactly on the
/// surface belongs to the inside on one side of a body and not on the other, so that bodies that share a wall share no
/// sample. Exact up to the rounding of an edge's crossing with a plane or row of samples. O(triangles + samples) and
/// the crossings, on all threads.
Mask voxelise(const Mesh &mesh, const Grid &grid);

} // namespace volsurf
