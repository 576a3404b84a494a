// The points of caps, which stay in the border planes of the grid wherever else finishing moves points.
#pragma once

#include "volsurf/core/grid.h"
#include "volsurf/core/mesh.h"

#include <vector>

namespace volsurf {

/// A point of a cap and the border plane that it must stay in.
struct CapPoint {
  PointId point;
  int axis;
  double index; ///< of the plane along the axis
};

/// The border planes of all points of caps, once per triangle of a cap. A point on the edge of two caps is in both
/// planes. O(triangles).
std::vector<CapPoint> find_cap_points(const Mesh &mesh, const Grid &grid);

} // namespace volsurf
