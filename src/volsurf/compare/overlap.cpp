#include "volsurf/compare/overlap.h"

#include "volsurf/compare/voxelise.h"
#include "volsurf/core/error.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace volsurf {

namespace {

constexpr double kDefaultParts = 256;

struct Bounds {
  Vec3 low;
  Vec3 high;
};

template <typename Place> Bounds bounds_of(const std::vector<Point> &points, Place place)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Bounds bounds{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (const Point &point : points) {
    const Vec3 at = place(Vec3{point[0], point[1], point[2]});
    for (int axis = 0; axis < 3; ++axis) {
      bounds.low[axis] = std::min(bounds.low[axis], at[axis]);
      bounds.high[axis] = std::max(bounds.high[axis], at[axis]);
    }
  }
  return bounds;
}

Bounds bounds_of_both(const Mesh &a, const Mesh &b)
{
  const auto stay = [](const Vec3 &world) { return world; };
  Bounds both = bounds_of(a.points, stay);
  const Bounds other = bounds_of(b.points, stay);
  for (int axis = 0; axis < 3; ++axis) {
    both.low[axis] = std::min(both.low[axis], other.low[axis]);
    both.high[axis] = std::max(both.high[axis], other.high[axis]);
  }
  return both;
}

/// The whole samples of the box from low to high.
GridBox box_between(const Vec3 &low, const Vec3 &high)
{
  GridBox box{};
  double samples = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = std::ceil(high[axis]) - std::floor(low[axis]) + 1;
    samples *= size;
    if (samples > static_cast<double>(kMostOverlapSamples))
      throw InputError("found surfaces so far apart, or so fine a grid, that their overlap would need more than 2^30 "
                       "samples; allowed: a larger --spacing, or surfaces in the same frame and unit");
    box.low[axis] = static_cast<std::int64_t>(std::floor(low[axis]));
    box.size[axis] = static_cast<std::int64_t>(size);
  }
  return box;
}

/// The box that holds a mask's grid and another box on the same lattice.
GridBox box_round(const Mask &mask, Vec3 low, Vec3 high)
{
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = std::min(low[axis], 0.0);
    high[axis] = std::max(high[axis], static_cast<double>(mask.grid.size[axis] - 1));
  }
  return box_between(low, high);
}

} // namespace

Overlap measure_overlap(const Mask &a, const Mask &b)
{
  assert(a.inside.size() == b.inside.size());
  Overlap overlap;
  overlap.spacing_mm = a.grid.spacing_mm;
  for (std::size_t i = 0; i < a.inside.size(); ++i) {
    overlap.samples_a += a.inside[i];
    overlap.samples_b += b.inside[i];
    overlap.samples_both += a.inside[i] & b.inside[i];
  }
  const auto sum = static_cast<double>(overlap.samples_a + overlap.samples_b);
  const auto both = static_cast<double>(overlap.samples_both);
  if (sum > 0) {
    overlap.dice = 2 * both / sum;
    overlap.jaccard = both / (sum - both);
  }
  return overlap;
}

Overlap measure_overlap(const Mask &a, const Mesh &b)
{
  const Bounds reach = bounds_of(b.points, [&](const Vec3 &world) { return world_to_index(a.grid, world); });
  const Mask whole = on_box(a, box_round(a, reach.low, reach.high));
  return measure_overlap(whole, voxelise(b, whole.grid));
}

double overlap_spacing_mm(const Mesh &a, const Mesh &b)
{
  const Bounds both = bounds_of_both(a, b);
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis)
    longest = std::max(longest, both.high[axis] - both.low[axis]);
  return longest / kDefaultParts;
}

Overlap measure_overlap(const Mesh &a, const Mesh &b, double spacing_mm)
{
  const double spacing = spacing_mm > 0 ? spacing_mm : overlap_spacing_mm(a, b);
  const Bounds both = bounds_of_both(a, b);
  Grid grid;
  grid.spacing_mm = {spacing, spacing, spacing};
  for (int axis = 0; axis < 3; ++axis) // half a voxel off, so that flat sides of the box are not on samples
    grid.origin_mm[axis] = both.low[axis] + 0.5 * spacing;
  grid.size = box_between({0, 0, 0}, world_to_index(grid, both.high)).size;
  return measure_overlap(voxelise(a, grid), voxelise(b, grid));
}

std::optional<Overlap> measure_lattice_overlap(const Mask &a, const Mask &b)
{
  const std::optional<Index3> offset = common_lattice(a.grid, b.grid);
  if (!offset)
    return std::nullopt;
  Vec3 low{};
  Vec3 high{};
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = static_cast<double>((*offset)[axis]);
    high[axis] = static_cast<double>((*offset)[axis] + b.grid.size[axis] - 1);
  }
  const GridBox box = box_round(a, low, high);
  const GridBox box_of_b{{box.low[0] - (*offset)[0], box.low[1] - (*offset)[1], box.low[2] - (*offset)[2]}, box.size};
  return measure_overlap(on_box(a, box), on_box(b, box_of_b));
}

} // namespace volsurf
