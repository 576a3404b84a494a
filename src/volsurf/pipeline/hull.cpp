#include "volsurf/pipeline/hull.h"

#include "volsurf/surface/islands.h"
#include "volsurf/topology/region_means.h"

#include <cmath>

namespace volsurf {

namespace {

/// Per region id, 1 where it looks like the background.
std::vector<char> look_like_background(const CellLabels &cells, const Volume &volume, const Regions &regions,
                                       RegionId background)
{
  const std::vector<double> means = region_means(cells, volume, regions);
  const std::vector<double> around = means_around(cells, regions, means);
  std::vector<char> alike(means.size());
  for (RegionId region = 1; region < means.size(); ++region) {
    const double difference = std::abs(means[region] - means[background]);
    alike[region] = region == background || difference < std::abs(around[region] - means[background]) / 2 ? 1 : 0;
  }
  return alike;
}

} // namespace

std::vector<char> find_outside_of_hull(const CellLabels &cells, const Volume &volume, const Regions &regions,
                                       RegionId background)
{
  std::vector<char> outside = look_like_background(cells, volume, regions, background);
  std::vector<RegionId> alike_of_basin = regions.of_basin;
  for (RegionId &region : alike_of_basin)
    region = outside[region] != 0 ? region : kNoRegion;
  const std::vector<RegionId> islands = find_islands(cells, alike_of_basin, regions.count(), kNoRegion);
  for (RegionId region = 1; region < outside.size(); ++region)
    outside[region] = outside[region] != 0 && islands[region] == islands[background] ? 1 : 0;
  return outside;
}

} // namespace volsurf
