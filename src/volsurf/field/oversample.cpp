#include "volsurf/field/oversample.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"

#include <algorithm>

namespace volsurf {

namespace {

/// Between b and c of four samples in a row.
float between(float a, float b, float c, float d)
{
  return (9 * (b + c) - (a + d)) * (1.0F / 16);
}

/// The four samples (rows, planes) around the place between `index` and the next of `count`.
std::array<std::int64_t, 4> around(std::int64_t index, std::int64_t count)
{
  return {std::max<std::int64_t>(index - 1, 0), index, index + 1, std::min(index + 2, count - 1)};
}

/// A row of `count` samples into one of 2 count - 1.
void refine_row(const float *row, std::int64_t count, float *out)
{
  for (std::int64_t i = 0; i < count; ++i)
    out[2 * i] = row[i];
  for (std::int64_t i = 0; i + 1 < count; ++i) {
    const auto [a, b, c, d] = around(i, count);
    out[2 * i + 1] = between(row[a], row[b], row[c], row[d]);
  }
}

/// Fills what lies between rows, or planes, of `length` samples: the odd ones of 2 count - 1.
void fill_between(float *rows, std::int64_t length, std::int64_t index, std::int64_t count)
{
  std::array<const float *, 4> from{};
  const auto sources = around(index, count);
  for (std::size_t k = 0; k < from.size(); ++k)
    from[k] = rows + 2 * sources[k] * length;
  float *const out = rows + (2 * index + 1) * length;
  for (std::int64_t i = 0; i < length; ++i)
    out[i] = between(from[0][i], from[1][i], from[2][i], from[3][i]);
}

/// A plane of the scan into the fine plane at its place.
void refine_plane(const float *plane, const Index3 &size, std::int64_t fine_length, float *out)
{
  for (std::int64_t y = 0; y < size[1]; ++y)
    refine_row(plane + y * size[0], size[0], out + 2 * y * fine_length);
  for (std::int64_t y = 0; y + 1 < size[1]; ++y)
    fill_between(out, fine_length, y, size[1]);
}

} // namespace

Grid oversampled_grid(const Grid &grid, int factor)
{
  Grid fine = grid;
  for (int axis = 0; axis < 3; ++axis) {
    fine.size[axis] = factor * (grid.size[axis] - 1) + 1;
    fine.spacing_mm[axis] = grid.spacing_mm[axis] / factor;
  }
  fine.oversampling = factor;
  return fine;
}

Grid scan_grid(const Grid &fine)
{
  Grid scan = fine;
  for (int axis = 0; axis < 3; ++axis) {
    scan.size[axis] = (fine.size[axis] - 1) / fine.oversampling + 1;
    scan.spacing_mm[axis] = fine.spacing_mm[axis] * fine.oversampling;
  }
  scan.oversampling = 1;
  return scan;
}

void oversample(Volume &volume, int factor)
{
  if (factor < 1 || factor > kLargestOversampling)
    throw UsageError("--oversample: found " + std::to_string(factor) + "; allowed are 1 and 2");
  if (factor == 1)
    return;
  const Index3 size = volume.grid.size;
  Volume fine{oversampled_grid(volume.grid, factor), {}};
  fine.samples.resize(static_cast<std::size_t>(fine.grid.sample_count()));
  const std::int64_t plane = fine.grid.size[0] * fine.grid.size[1];
  const auto for_each_plane = [](std::int64_t count, const auto &work) {
    parallel_for_slabs(count, 1, [&](const Slab &slab) { work(slab.begin); });
  };
  for_each_plane(size[2], [&](std::int64_t z) {
    refine_plane(volume.samples.data() + z * size[0] * size[1], size, fine.grid.size[0],
                 fine.samples.data() + 2 * z * plane);
  });
  for_each_plane(size[2] - 1, [&](std::int64_t z) { fill_between(fine.samples.data(), plane, z, size[2]); });
  volume = std::move(fine);
}

} // namespace volsurf
