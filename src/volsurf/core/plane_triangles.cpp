#include "volsurf/core/plane_triangles.h"

#include <cmath>
#include <numeric>

namespace volsurf {

namespace {

/// Calls visit(plane, t) for each plane that triangle t crosses.
template <typename Visit>
void for_each_pair(const std::vector<Triangle> &triangles, const std::vector<Vec3> &points, std::size_t plane_count,
                   Visit visit)
{
  const auto planes = static_cast<std::int64_t>(plane_count);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [low, high] =
        std::minmax({points[triangles[t][0]][2], points[triangles[t][1]][2], points[triangles[t][2]][2]});
    const double first = std::clamp(std::floor(low) + 1, 0.0, static_cast<double>(planes));
    const double last = std::clamp(std::floor(high), -1.0, static_cast<double>(planes - 1));
    for (auto plane = static_cast<std::int64_t>(first); plane <= static_cast<std::int64_t>(last); ++plane)
      visit(static_cast<std::size_t>(plane), t);
  }
}

} // namespace

PlaneTriangles::PlaneTriangles(const Mesh &mesh, const Grid &grid)
    : triangles_(mesh.triangles), start_(static_cast<std::size_t>(grid.size[2]) + 1, 0)
{
  points_.reserve(mesh.points.size());
  for (const Point &p : mesh.points)
    points_.push_back(world_to_index(grid, {p[0], p[1], p[2]}));
  const std::size_t planes = start_.size() - 1;
  for_each_pair(triangles_, points_, planes, [&](std::size_t plane, std::size_t) { ++start_[plane + 1]; });
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  crossing_.resize(start_.back());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for_each_pair(triangles_, points_, planes, [&](std::size_t plane, std::size_t t) { crossing_[next[plane]++] = t; });
}

Crossing PlaneTriangles::crossing(PointId low, PointId high, double plane) const
{
  const Vec3 &a = points_[low];
  const Vec3 &b = points_[high];
  const double part = (plane - a[2]) / (b[2] - a[2]);
  return {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])};
}

} // namespace volsurf
