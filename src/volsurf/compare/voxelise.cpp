#include "volsurf/compare/voxelise.h"

#include "volsurf/core/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace volsurf {

namespace {

/// Where an edge or a triangle meets a plane or a row of samples, in index coordinates.
struct Crossing {
  double x;
  double y;
};

/// A surface in the index coordinates of a grid, and for each plane of samples the triangles that cross it.
class PlaneTriangles {
public:
  PlaneTriangles(const Mesh &mesh, const Grid &grid) : triangles_(mesh.triangles), start_(grid.size[2] + 1, 0)
  {
    points_.reserve(mesh.points.size());
    for (const Point &p : mesh.points)
      points_.push_back(world_to_index(grid, {p[0], p[1], p[2]}));
    for_each_pair([&](std::size_t plane, std::size_t) { ++start_[plane + 1]; });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    crossing_.resize(start_.back());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for_each_pair([&](std::size_t plane, std::size_t t) { crossing_[next[plane]++] = t; });
  }

  /// Calls visit(from, to) for each triangle that crosses the plane. Its inside lies where y grows from `from` to `to`
  /// and x is larger, or y decreases and x is smaller, if its normals point outwards and the grid is not mirrored.
  template <typename Visit> void for_each_segment(std::int64_t plane, Visit visit) const
  {
    for (std::size_t i = start_[plane]; i < start_[plane + 1]; ++i)
      visit_segment(triangles_[crossing_[i]], static_cast<double>(plane), visit);
  }

private:
  /// A corner on a plane counts as above it, here and below, so that every edge that crosses is seen from both sides.
  template <typename Visit> void for_each_pair(Visit visit) const
  {
    const auto planes = static_cast<std::int64_t>(start_.size()) - 1;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto [low, high] =
          std::minmax({points_[triangles_[t][0]][2], points_[triangles_[t][1]][2], points_[triangles_[t][2]][2]});
      const double first = std::clamp(std::floor(low) + 1, 0.0, static_cast<double>(planes));
      const double last = std::clamp(std::floor(high), -1.0, static_cast<double>(planes - 1));
      for (auto plane = static_cast<std::int64_t>(first); plane <= static_cast<std::int64_t>(last); ++plane)
        visit(static_cast<std::size_t>(plane), t);
    }
  }

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

  /// Given its ends in order, so that both triangles at an edge find the same place to the last bit.
  Crossing crossing(PointId low, PointId high, double plane) const
  {
    const Vec3 &a = points_[low];
    const Vec3 &b = points_[high];
    const double part = (plane - a[2]) / (b[2] - a[2]);
    return {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])};
  }

  const std::vector<Triangle> &triangles_;
  std::vector<Vec3> points_;
  std::vector<std::size_t> start_; ///< of each plane's triangles in crossing_
  std::vector<std::size_t> crossing_;
};

/// Adds a segment to the changes of the winding number: at each row that it crosses, at the first sample behind it.
void add_segment(const Crossing &up, const Crossing &down, const Index3 &size, std::vector<std::int32_t> &changes)
{
  const Crossing &low = up.y < down.y ? up : down;
  const Crossing &high = up.y < down.y ? down : up;
  const std::int32_t change = up.y < down.y ? 1 : -1;
  const double first = std::clamp(std::floor(low.y) + 1, 0.0, static_cast<double>(size[1]));
  const double last = std::clamp(std::floor(high.y), -1.0, static_cast<double>(size[1] - 1));
  for (auto row = static_cast<std::int64_t>(first); row <= static_cast<std::int64_t>(last); ++row) {
    const double part = (static_cast<double>(row) - low.y) / (high.y - low.y);
    const double x = std::clamp(std::ceil(low.x + part * (high.x - low.x)), 0.0, static_cast<double>(size[0]));
    changes[static_cast<std::size_t>(row * (size[0] + 1) + static_cast<std::int64_t>(x))] += change;
  }
}

/// Winding numbers along each row, which are 0 outside.
void fill_plane(const std::vector<std::int32_t> &changes, const Index3 &size, std::uint8_t *inside)
{
  for (std::int64_t y = 0; y < size[1]; ++y) {
    std::int32_t winding = 0;
    for (std::int64_t x = 0; x < size[0]; ++x) {
      winding += changes[static_cast<std::size_t>(y * (size[0] + 1) + x)];
      inside[y * size[0] + x] = winding != 0 ? 1 : 0;
    }
  }
}

} // namespace

Mask voxelise(const Mesh &mesh, const Grid &grid)
{
  Mask mask{grid, std::vector<std::uint8_t>(static_cast<std::size_t>(grid.sample_count()))};
  const PlaneTriangles planes(mesh, grid);
  const Index3 &size = grid.size;
  parallel_for_slabs(size[2], large_slab(size[2]), [&](const Slab &slab) {
    std::vector<std::int32_t> changes(static_cast<std::size_t>((size[0] + 1) * size[1]));
    for (std::int64_t z = slab.begin; z < slab.end; ++z) {
      std::fill(changes.begin(), changes.end(), 0);
      planes.for_each_segment(z,
                              [&](const Crossing &up, const Crossing &down) { add_segment(up, down, size, changes); });
      fill_plane(changes, size, mask.inside.data() + z * size[0] * size[1]);
    }
  });
  return mask;
}

} // namespace volsurf
