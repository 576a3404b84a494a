// The points that an edge joins to each point of a mesh.
#pragma once

#include "volsurf/core/mesh.h"

#include <vector>

namespace volsurf {

class PointNeighbours {
public:
  /// O(triangles).
  explicit PointNeighbours(const Mesh &mesh);

  std::size_t size() const { return begin_.size() - 1; }
  std::size_t count(std::size_t point) const { return begin_[point + 1] - begin_[point]; }

  /// Calls visit(neighbour) for a point's neighbours, in ascending order.
  template <typename Visit> void for_each(std::size_t point, Visit visit) const
  {
    for (std::size_t i = begin_[point]; i < begin_[point + 1]; ++i)
      visit(neighbours_[i]);
  }

private:
  std::vector<std::size_t> begin_; // per point
  std::vector<PointId> neighbours_;
};

} // namespace volsurf
