#include "volsurf/surface/islands.h"

#include <algorithm>
#include <numeric>

namespace volsurf {

namespace {

/// Union-find over regions; the representative of a set is its smallest id.
class RegionForest {
public:
  explicit RegionForest(std::size_t regions) : parent_(regions + 1)
  {
    std::iota(parent_.begin(), parent_.end(), RegionId{0});
  }

  RegionId find(RegionId region)
  {
    while (parent_[region] != region) {
      parent_[region] = parent_[parent_[region]];
      region = parent_[region];
    }
    return region;
  }

  void join(RegionId a, RegionId b)
  {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<RegionId> parent_;
};

/// Joins the regions of two rows of cells that lie side by side.
void join_rows(const RegionId *a, const RegionId *b, std::int64_t count, RegionForest &islands)
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
  RegionForest forest(regions);
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
