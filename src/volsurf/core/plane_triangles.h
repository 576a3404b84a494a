// Where a surface crosses the planes of samples of a grid.
//
// Crossings are in the fractional indices of the grid. What lies exactly on a plane counts as above it, everywhere, so
// that a closed surface has closed outlines.
#pragma once

#include "volsurf/core/grid.h"
#include "volsurf/core/mesh.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

/// Where an edge or a triangle meets a plane or a row of samples, in index coordinates.
struct Crossing {
  double x;
  double y;
};

/// Calls visit(row, x, up) where a segment of a plane crosses the rows at y = row + offset, row in 0 .. rows - 1; `up`
/// tells whether y grows along it. An end on a row counts as above it.
template <typename Visit>
void for_each_crossed_row(const Crossing &from, const Crossing &to, double offset, std::int64_t rows, Visit visit)
{
  const bool up = from.y < to.y;
  const Crossing &low = up ? from : to;
  const Crossing &high = up ? to : from;
  const double first = std::clamp(std::floor(low.y - offset) + 1, 0.0, static_cast<double>(rows));
  const double last = std::clamp(std::floor(high.y - offset), -1.0, static_cast<double>(rows - 1));
  for (auto row = static_cast<std::int64_t>(first); row <= static_cast<std::int64_t>(last); ++row) {
    const double part = (static_cast<double>(row) + offset - low.y) / (high.y - low.y);
    visit(row, low.x + part * (high.x - low.x), up);
  }
}

/// A surface in the index coordinates of a grid, and for each plane of samples the triangles that cross it.
class PlaneTriangles {
public:
  /// Keeps a reference to the triangles. O(triangles and the planes that each crosses).
  PlaneTriangles(const Mesh &mesh, const Grid &grid);

  /// Calls visit(from, to) for each triangle that crosses the plane. Its inside lies where y grows from `from` to `to`
  /// and x is larger, or y decreases and x is smaller, if its normals point outwards and the grid is not mirrored.
  template <typename Visit> void for_each_segment(std::int64_t plane, Visit visit) const
  {
    for (std::size_t i = start_[plane]; i < start_[plane + 1]; ++i)
      visit_segment(triangles_[crossing_[i]], static_cast<double>(plane), visit);
  }

private:
  template <typename Visit> void visit_segment(const Triangle &triangle, double plane, Visit visit) const
  {
    Crossing up{};
    Crossing down{};
    for (int i = 0; i < 3; ++i) {
      const PointId from = triangle[i];
      const PointId to = triangle[(i + 1) % 3];
      const bool from_above = points_[from][2] >= plane;
      const bool to_above = points_[to][2] >= plane;
      if (from_above != to_above)
        (to_above ? up : down) = crossing(std::min(from, to), std::max(from, to), plane);
    }
    visit(up, down);
  }

  Crossing crossing(PointId low, PointId high, double plane) const;

  const std::vector<Triangle> &triangles_;
  std::vector<Vec3> points_;
  std::vector<std::size_t> start_; ///< of each plane's triangles in crossing_
  std::vector<std::size_t> crossing_;
};

} // namespace volsurf
