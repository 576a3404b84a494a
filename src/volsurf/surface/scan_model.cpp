#include "volsurf/surface/scan_model.h"

#include "volsurf/core/parallel.h"
#include "volsurf/core/vectorise.h"
#include "volsurf/surface/voxel_shares.h"

#include <algorithm>

namespace volsurf {

namespace {

void copy_samples(const Volume &volume, const Window &window, PaddedRows *rows)
{
  const std::int64_t step = volume.grid.oversampling;
  parallel_for_slabs(rows->size[2], 1, [&](const Slab &slab) {
    for (std::int64_t z = slab.begin; z < slab.end; ++z)
      for (std::int64_t y = 0; y < rows->size[1]; ++y) {
        const Index3 first{step * window.begin[0], step * (window.begin[1] + y), step * (window.begin[2] + z)};
        const float *const from =
            volume.samples.data() + first[0] + volume.grid.size[0] * (first[1] + volume.grid.size[1] * first[2]);
        float *const to = rows->row(y, z);
        for (std::int64_t x = 0; x < rows->size[0]; ++x)
          to[x] = from[step * x];
      }
  });
}

VOLSURF_VECTORISE void take_least(const float *parts, std::int64_t count, float *least)
{
  for (std::int64_t x = 0; x < count; ++x)
    least[x] = std::min(least[x], parts[x]);
}

/// Of `wide` three parts in a row count, of `narrow` one.
VOLSURF_VECTORISE void combine_least(const float *wide, const float *narrow, std::int64_t count, float *least)
{
  for (std::int64_t x = 0; x < count; ++x)
    least[x] = std::min(std::min(narrow[x], wide[x]), std::min(wide[x - 1], wide[x + 1]));
}

/// Of each sample that counts the least part inside, of itself and those of the 18 around it that count. With all 26
/// the layer is thicker, and the brain of the study's head up to a tenth further off.
void find_least_parts(const PaddedRows &shares, const Window &window, PaddedRows *least)
{
  const auto first = [&](int axis) { return window.first_that_counts(axis); };
  const auto end = [&](int axis) { return window.end_of_those_that_count(axis); };
  const std::int64_t count = end(0) - first(0);
  if (count <= 0)
    return;
  parallel_for_slabs(std::max<std::int64_t>(end(2) - first(2), 0), 1, [&](const Slab &slab) {
    std::vector<float> wide(static_cast<std::size_t>(count) + 2);
    std::vector<float> narrow(wide.size());
    for (std::int64_t z = first(2) + slab.begin; z < first(2) + slab.end; ++z)
      for (std::int64_t y = first(1); y < end(1); ++y) {
        std::fill(wide.begin(), wide.end(), 1.0F);
        std::fill(narrow.begin(), narrow.end(), 1.0F);
        for (std::int64_t k = std::max(z - 1, first(2)); k < std::min(z + 2, end(2)); ++k)
          for (std::int64_t j = std::max(y - 1, first(1)); j < std::min(y + 2, end(1)); ++j)
            take_least(shares.row(j, k) + first(0), count, (j != y && k != z ? narrow : wide).data() + 1);
        combine_least(wide.data() + 1, narrow.data() + 1, count, least->row(y, z) + first(0));
      }
  });
}

} // namespace

PaddedRows::PaddedRows(const Index3 &s) : size(s), values(static_cast<std::size_t>((s[0] + 2 * kPadding) * s[1] * s[2]))
{
}

ScanModel::ScanModel(const Window &w, const Volume &volume, Inside i)
    : window(w), inside(i), samples(w.grid.size), shares(w.grid.size), beyond_shares(w.grid.size)
{
  copy_samples(volume, window, &samples);
}

void ScanModel::set_surface(const Mesh &mesh)
{
  shares.values = {}; // the last ones make room first
  shares.values = voxel_shares(mesh, window.grid, PaddedRows::kPadding);
  if (inside == Inside::layered)
    find_least_parts(shares, window, &beyond_shares);
}

} // namespace volsurf
