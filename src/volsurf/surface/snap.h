// Sub-voxel placement: the points of a surface move along its normal to the edge of the volume.
//
// In: a mesh whose staircase has been smoothed, and a function that finds the edge along a line and tells how far off
// it may be. Out: the same mesh, its points moved. Guarantees: no point moves further than the limit, caps stay in the
// border planes of the grid, no triangle turns over, and no thread count changes a byte. Passes: the way of each point
// to its edge; ways far from those around are dropped; all points are placed at once, near their edges as far as those
// are certain (fairing.h), points without a way, those on junction curves among them, with their neighbours; moves that
// would turn a triangle over are taken back.
#pragma once

#include "volsurf/core/located_edge.h"
#include "volsurf/surface/placement.h"

#include <functional>
#include <optional>

namespace volsurf {

/// The edge from a fractional index along a direction (unit length, mm along the grid's axes), nothing where there is
/// none within a limit in mm. Called from several threads.
using FindEdge = std::function<std::optional<LocatedEdge>(const Vec3 &index, const Vec3 &direction, double limit_mm)>;

/// How far off an edge counts as at least, in voxels of the smallest spacing. From 0.03 to 0.06 all of the study's
/// shapes without noise gain; at 0.1 creases begin to suffer, while the terraces of masks and labels go.
constexpr double kLeastError = 0.06;

/// O(points * steps of find_edge), parallel.
PlacementResult snap_mesh(Mesh &mesh, const Grid &grid, const FindEdge &find_edge, double least_error = kLeastError);

} // namespace volsurf
