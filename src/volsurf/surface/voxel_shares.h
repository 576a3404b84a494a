// What part of each voxel a closed surface encloses: the scan that a body of 1 on 0 would give.
//
// Of each voxel 16 lines along x are looked at; along them the parts are exact. A voxel reaches half a spacing from its
// sample to all sides.
#pragma once

#include "volsurf/core/grid.h"
#include "volsurf/core/mesh.h"

#include <vector>

namespace volsurf {

/// One number in 0 .. 1 per sample of the grid, x fastest, whichever way the normals point; before and after each row
/// `padding` zeros. Parallel; no thread count changes a byte. O(samples) and the crossings of triangles and lines.
std::vector<float> voxel_shares(const Mesh &mesh, const Grid &grid, std::int64_t padding = 0);

} // namespace volsurf
