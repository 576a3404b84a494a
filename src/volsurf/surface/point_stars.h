// Which triangles meet at each point of a mesh.
#pragma once

#include "volsurf/core/mesh.h"

#include <numeric>

namespace volsurf {

class PointStars {
public:
  /// O(points + triangles).
  explicit PointStars(const Mesh &mesh) : begin_(mesh.points.size() + 1), triangles_(3 * mesh.triangles.size())
  {
    for (const Triangle &triangle : mesh.triangles)
      for (const PointId point : triangle)
        ++begin_[std::size_t{point} + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    auto next = begin_;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (const PointId point : mesh.triangles[t])
        triangles_[next[point]++] = t;
  }

  /// Calls visit(index of a triangle) for the triangles at a point, in ascending order.
  template <typename Visit> void for_each(PointId point, Visit visit) const
  {
    for (std::size_t i = begin_[point]; i < begin_[std::size_t{point} + 1]; ++i)
      visit(triangles_[i]);
  }

private:
  std::vector<std::size_t> begin_; // per point
  std::vector<std::size_t> triangles_;
};

} // namespace volsurf
