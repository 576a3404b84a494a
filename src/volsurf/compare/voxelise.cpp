#include "volsurf/compare/voxelise.h"

#include "volsurf/core/parallel.h"
#include "volsurf/core/plane_triangles.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

/// Adds a segment to the changes of the winding number: at each row that it crosses, at the first sample behind it.
void add_segment(const Crossing &from, const Crossing &to, const Index3 &size, std::vector<std::int32_t> &changes)
{
  for_each_crossed_row(from, to, 0, size[1], [&](std::int64_t row, double x, bool up) {
    const auto sample = static_cast<std::int64_t>(std::clamp(std::ceil(x), 0.0, static_cast<double>(size[0])));
    changes[static_cast<std::size_t>(row * (size[0] + 1) + sample)] += up ? 1 : -1;
  });
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
                              [&](const Crossing &from, const Crossing &to) { add_segment(from, to, size, changes); });
      fill_plane(changes, size, mask.inside.data() + z * size[0] * size[1]);
    }
  });
  return mask;
}

} // namespace volsurf
