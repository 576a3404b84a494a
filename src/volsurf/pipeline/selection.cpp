#include "volsurf/pipeline/selection.h"

#include "volsurf/core/error.h"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace volsurf {

namespace {

/// The region of the cell that holds a point.
RegionId region_at(const Vec3 &seed_mm, const Settings &settings, const Grid &grid, const RegionMerge &merge,
                   const Regions &regions)
{
  const double sign = settings.frame == Frame::ras ? -1 : 1;
  const Vec3 index = world_to_index(grid, {sign * seed_mm[0], sign * seed_mm[1], seed_mm[2]});
  std::array<std::int64_t, 3> cell{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto last = static_cast<double>(grid.size[axis] - 1);
    if (!(index[axis] >= 0 && index[axis] <= last)) {
      std::ostringstream message;
      message << "--seed " << seed_mm[0] << ',' << seed_mm[1] << ',' << seed_mm[2] << ": it lies outside the volume";
      throw UsageError(message.str());
    }
    cell[axis] = std::min(static_cast<std::int64_t>(index[axis]), grid.size[axis] - 2);
  }
  return regions.of_basin[merge.cells.basins[CellGrid(merge.cells.size).id(cell[0], cell[1], cell[2])]];
}

} // namespace

Selection select_sides(const Settings &settings, const Grid &grid, const RegionMerge &merge, const Regions &regions,
                       RegionId background)
{
  std::vector<RegionId> side(regions.count() + 1);
  if (settings.surface == SurfaceKind::hull)
    std::fill(side.begin() + 1, side.end(), RegionId{1});
  else if (settings.seeds_mm.empty())
    std::iota(side.begin(), side.end(), RegionId{0});
  side[background] = 0;
  for (const Vec3 &seed : settings.seeds_mm) {
    const RegionId region = region_at(seed, settings, grid, merge, regions);
    side[region] = region;
  }
  Selection selection{{regions.of_basin, side[background]}, false};
  for (RegionId &basin_side : selection.sides.of_basin)
    basin_side = side[basin_side];
  std::sort(side.begin(), side.end());
  selection.one_thing = std::unique(side.begin(), side.end()) - side.begin() == 2;
  return selection;
}

} // namespace volsurf
