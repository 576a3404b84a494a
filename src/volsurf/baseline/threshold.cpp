#include "volsurf/baseline/threshold.h"

#include "volsurf/core/parallel.h"

namespace volsurf {

LabelVolume threshold(const Volume &volume, double iso)
{
  const Grid &grid = volume.grid;
  LabelVolume result{grid, std::vector<std::uint32_t>(volume.samples.size())};
  const std::int64_t plane = grid.size[0] * grid.size[1];
  constexpr std::int64_t kPlanesPerSlab = 16;
  parallel_for_slabs(grid.size[2], kPlanesPerSlab, [&](const Slab &slab) {
    for (auto i = static_cast<std::size_t>(slab.begin * plane); i < static_cast<std::size_t>(slab.end * plane); ++i)
      result.labels[i] = static_cast<double>(volume.samples[i]) >= iso ? 1 : 0;
  });
  return result;
}

} // namespace volsurf
