#include "volsurf/surface/islands.h"

#include "volsurf/core/index_forest.h"

#include <algorithm>

namespace volsurf {

namespace {

/// Joins the regions of two rows of cells that lie side by side.
void join_rows(const RegionId *a, const RegionId *b, std::int64_t count, IndexForest &islands)
{
  for (std::int64_t i = 0; i < count; ++i)
    if (a[i] != b[i] && a[i] != kNoRegion && b[i] != kNoRegion)
      islands.join(a[i], b[i]);
}

} // namespace

std::vector<RegionId> find_islands(const CellLabels &cells, const std::vector<RegionId> &region_of_basin,
                                   std::size_t regions, RegionId background)
{
  const auto &[nx, ny, nz] = cells.size;
  IndexForest forest(static_cast<std::uint32_t>(regions + 1));
  std::vector<RegionId> below(static_cast<std::size_t>(nx * ny));
  std::vector<RegionId> plane = below;
  for (std::int64_t z = 0; z < nz; ++z) {
    const BasinId *const basins = cells.basins.data() + z * nx * ny;
    std::transform(basins, basins + nx * ny, plane.begin(), [&](BasinId basin) {
      return region_of_basin[basin] == background ? kNoRegion : region_of_basin[basin];
    });
    for (std::int64_t y = 0; y < ny; ++y) {
      const RegionId *const row = plane.data() + y * nx;
      join_rows(row, row + 1, nx - 1, forest);
      if (y > 0)
        join_rows(row - nx, row, nx, forest);
    }
    join_rows(below.data(), plane.data(), z > 0 ? nx * ny : 0, forest);
    std::swap(below, plane);
  }

  std::vector<RegionId> island(regions + 1);
  for (RegionId region = 1; region <= regions; ++region)
    island[region] = region == background ? kNoRegion : forest.find(region);
  return island;
}

} // namespace volsurf
