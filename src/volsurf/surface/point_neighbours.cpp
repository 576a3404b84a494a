#include "volsurf/surface/point_neighbours.h"

#include <algorithm>
#include <numeric>

namespace volsurf {

PointNeighbours::PointNeighbours(const Mesh &mesh) : begin_(mesh.points.size() + 1)
{
  // Each triangle names two neighbours of each of its points, most of them twice.
  std::vector<std::size_t> next(mesh.points.size() + 1);
  for (const Triangle &triangle : mesh.triangles)
    for (const PointId point : triangle)
      next[std::size_t{point} + 1] += 2;
  std::partial_sum(next.begin(), next.end(), next.begin());
  const std::vector<std::size_t> begin = next;
  std::vector<PointId> named(next.back());
  for (const auto &[a, b, c] : mesh.triangles) {
    for (const PointId other : {b, c})
      named[next[a]++] = other;
    for (const PointId other : {a, c})
      named[next[b]++] = other;
    for (const PointId other : {a, b})
      named[next[c]++] = other;
  }
  for (std::size_t point = 0; point < mesh.points.size(); ++point) {
    const auto first = named.begin() + static_cast<std::ptrdiff_t>(begin[point]);
    const auto last = named.begin() + static_cast<std::ptrdiff_t>(begin[point + 1]);
    std::sort(first, last);
    neighbours_.insert(neighbours_.end(), first, std::unique(first, last));
    begin_[point + 1] = neighbours_.size();
  }
}

} // namespace volsurf
