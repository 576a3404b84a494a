#include "volsurf/pipeline/selection.h"

#include "volsurf/core/error.h"
#include "volsurf/pipeline/hull.h"
#include "volsurf/surface/islands.h"

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

/// A region's number, as a user gives it.
RegionId checked_region(std::int64_t number, const Regions &regions)
{
  const auto count = static_cast<std::int64_t>(regions.count());
  if (number < 1 || number > count)
    throw UsageError("--region: found " + std::to_string(number) + "; allowed are 1 to " + std::to_string(count) +
                     ": there are " + std::to_string(count) + " regions at this delta");
  return static_cast<RegionId>(number);
}

/// Those that --seed and --region name.
std::vector<RegionId> named_regions(const Settings &settings, const Grid &grid, const RegionMerge &merge,
                                    const Regions &regions)
{
  std::vector<RegionId> named;
  for (const Vec3 &seed : settings.seeds_mm)
    named.push_back(region_at(seed, settings, grid, merge, regions));
  for (const std::int64_t number : settings.region_numbers)
    named.push_back(checked_region(number, regions));
  std::sort(named.begin(), named.end());
  named.erase(std::unique(named.begin(), named.end()), named.end());
  return named;
}

[[noreturn]] void refuse_emptiness(const Settings &settings, double largest_mm3)
{
  const std::string things = settings.surface == SurfaceKind::hull ? "island" : "region";
  std::ostringstream message;
  message << settings.input.string() << ": no " << things << " has --min-volume " << settings.min_volume_mm3
          << " mm3; the largest beside the background has " << largest_mm3 << " mm3";
  throw EmptyResult(message.str());
}

/// Per region id, 1 for the background and all else that a surface around everything leaves outside.
std::vector<char> outside_of(const Settings &settings, const Volume &volume, const RegionMerge &merge,
                             const Regions &regions, RegionId background)
{
  const bool has_intensities = settings.method == Method::volsurf && !settings.field.edge_map;
  if (settings.surface == SurfaceKind::hull && has_intensities)
    return find_outside_of_hull(merge.cells, volume, regions, background);
  std::vector<char> outside(regions.count() + 1);
  outside[background] = 1;
  return outside;
}

/// What --min-volume measures for each region: itself or, for a hull, all that hangs together with it inside.
std::vector<RegionId> things_of_regions(const Settings &settings, const RegionMerge &merge, const Regions &regions,
                                        const std::vector<char> &outside)
{
  if (settings.surface == SurfaceKind::hull && settings.min_volume_mm3 > 0) {
    std::vector<RegionId> inside_of_basin = regions.of_basin;
    for (RegionId &region : inside_of_basin)
      region = outside[region] != 0 ? kNoRegion : region;
    return find_islands(merge.cells, inside_of_basin, regions.count(), kNoRegion);
  }
  std::vector<RegionId> thing(regions.count() + 1);
  std::iota(thing.begin(), thing.end(), RegionId{0});
  return thing;
}

/// Those that are inside, and of at least --min-volume.
std::vector<RegionId> large_regions(const Settings &settings, const Volume &volume, const Grid &grid,
                                    const RegionMerge &merge, const Regions &regions, RegionId background)
{
  const std::vector<char> outside = outside_of(settings, volume, merge, regions, background);
  const std::vector<RegionId> thing = things_of_regions(settings, merge, regions, outside);
  std::vector<std::int64_t> cells(thing.size());
  for (RegionId region = 1; region < thing.size(); ++region)
    if (outside[region] == 0)
      cells[thing[region]] += regions.cell_counts[region - 1];

  const double cell_mm3 = voxel_volume_mm3(grid);
  std::vector<RegionId> large;
  for (RegionId region = 1; region < thing.size(); ++region)
    if (outside[region] == 0 && static_cast<double>(cells[thing[region]]) * cell_mm3 >= settings.min_volume_mm3)
      large.push_back(region);
  if (large.empty())
    refuse_emptiness(settings, static_cast<double>(*std::max_element(cells.begin(), cells.end())) * cell_mm3);
  return large;
}

} // namespace

Selection select_sides(const Settings &settings, const Volume &volume, const Grid &grid, const RegionMerge &merge,
                       const Regions &regions, RegionId background)
{
  Selection selection;
  selection.regions = named_regions(settings, grid, merge, regions);
  if (selection.regions.empty())
    selection.regions = large_regions(settings, volume, grid, merge, regions, background);

  std::vector<RegionId> side(regions.count() + 1);
  for (const RegionId region : selection.regions)
    side[region] = settings.surface == SurfaceKind::hull ? 1 : region;
  selection.sides = {regions.of_basin, side[background]};
  for (RegionId &basin_side : selection.sides.of_basin)
    basin_side = side[basin_side];
  selection.one_thing = settings.surface == SurfaceKind::hull || selection.regions.size() == 1;
  return selection;
}

} // namespace volsurf
