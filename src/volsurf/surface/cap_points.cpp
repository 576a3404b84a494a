#include "volsurf/surface/cap_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace volsurf {

namespace {

bool near(double a, double b)
{
  return std::abs(a - b) < 1e-3;
}

} // namespace

std::vector<CapPoint> find_cap_points(const Mesh &mesh, const Grid &grid)
{
  std::vector<CapPoint> cap_points;
  if (mesh.cap.empty())
    return cap_points;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.cap[t] == 0)
      continue;
    std::array<Vec3, 3> corners{};
    for (int i = 0; i < 3; ++i) {
      const Point &p = mesh.points[mesh.triangles[t][i]];
      corners[i] = world_to_index(grid, {p[0], p[1], p[2]});
    }
    for (int axis = 0; axis < 3; ++axis)
      for (const double plane : {0.0, static_cast<double>(grid.size[axis] - 1)})
        if (std::all_of(corners.begin(), corners.end(), [&](const Vec3 &corner) { return near(corner[axis], plane); }))
          for (const PointId point : mesh.triangles[t])
            cap_points.push_back({point, axis, plane});
  }
  return cap_points;
}

} // namespace volsurf
