// The triangle mesh that the surface stages pass on and the writers write.
#pragma once

#include "volsurf/core/ids.h"

#include <array>
#include <cstdint>
#include <vector>

namespace volsurf {

using Point = std::array<float, 3>;
using Triangle = std::array<PointId, 3>;

/// Points are in world millimetres (LPS) and shared between triangles. The arrays below hold one entry per triangle.
/// A triangle's normal points from its region a (inside) to its region b (outside).
struct Mesh {
  std::vector<Point> points;
  std::vector<Triangle> triangles;

  std::vector<RegionId> region_a;
  std::vector<RegionId> region_b;
  std::vector<float> persistence;     ///< saliency: the surface at delta holds the triangles with saliency >= delta
  std::vector<ComponentId> component; ///< 1 is the largest
  std::vector<std::uint8_t> cap;      ///< 1 where the triangle closes a region at the edge of the scan
};

} // namespace volsurf
