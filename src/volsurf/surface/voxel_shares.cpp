#include "volsurf/surface/voxel_shares.h"

#include "volsurf/core/parallel.h"
#include "volsurf/core/plane_triangles.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

/// Lines along x through each voxel. No two of them are at the same height along y or along z, so that walls along the
/// axes are told apart as well as others.
constexpr int kLines = 16;
constexpr int kLinesApart = 7; ///< along y, from one to the next along z

/// Where a line is in its voxel, along y.
double line_offset(std::int64_t line)
{
  return (static_cast<double>(line * kLinesApart % kLines) + 0.5) / kLines - 0.5;
}

/// The same voxels, with a plane for each line in them.
Grid grid_of_lines(const Grid &grid)
{
  Grid lines = grid;
  lines.origin_mm = index_to_world(grid, {0, 0, 0.5 / kLines - 0.5});
  lines.size[2] *= kLines;
  lines.spacing_mm[2] /= kLines;
  return lines;
}

/// Adds what a segment changes along the lines that it crosses, which are `offset` above the samples: the voxel that it
/// crosses by the part behind it, the next one by what is left of 1. `changes` holds a row for each row of voxels, one
/// longer than these.
void add_segment(const Crossing &from, const Crossing &to, double offset, const Index3 &size, float *changes)
{
  for_each_crossed_row(from, to, offset, size[1], [&](std::int64_t row, double crossing, bool up) {
    const double change = (up ? 1.0 : -1.0) / kLines;
    const double x = std::clamp(crossing + 0.5, 0.0, static_cast<double>(size[0]));
    const auto voxel = std::min(static_cast<std::int64_t>(x), size[0] - 1);
    float *const at = changes + row * (size[0] + 1) + voxel;
    const double behind = 1 - (x - static_cast<double>(voxel));
    at[0] += static_cast<float>(change * behind);
    at[1] += static_cast<float>(change * (1 - behind));
  });
}

/// One row of `changes`.
void sum_up(const float *changes, std::int64_t size, float *shares)
{
  float sum = 0;
  for (std::int64_t x = 0; x < size; ++x) {
    sum += changes[x];
    shares[x] = std::min(std::abs(sum), 1.0F);
  }
}

} // namespace

std::vector<float> voxel_shares(const Mesh &mesh, const Grid &grid, std::int64_t padding)
{
  const std::int64_t row_length = grid.size[0] + 2 * padding;
  std::vector<float> shares(static_cast<std::size_t>(row_length * grid.size[1] * grid.size[2]));
  const PlaneTriangles planes(mesh, grid_of_lines(grid));
  const Index3 &size = grid.size;
  parallel_for_slabs(size[2], 1, [&](const Slab &slab) {
    std::vector<float> changes(static_cast<std::size_t>((size[0] + 1) * size[1]));
    for (std::int64_t z = slab.begin; z < slab.end; ++z) {
      std::fill(changes.begin(), changes.end(), 0.0F);
      for (std::int64_t line = 0; line < kLines; ++line)
        planes.for_each_segment(kLines * z + line, [&](const Crossing &from, const Crossing &to) {
          add_segment(from, to, line_offset(line), size, changes.data());
        });
      for (std::int64_t y = 0; y < size[1]; ++y)
        sum_up(changes.data() + y * (size[0] + 1), size[0], shares.data() + (z * size[1] + y) * row_length + padding);
    }
  });
  return shares;
}

} // namespace volsurf
