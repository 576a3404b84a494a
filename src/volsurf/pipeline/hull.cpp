#include "volsurf/pipeline/hull.h"

#include "volsurf/topology/region_means.h"

#include <cmath>

namespace volsurf {

namespace {

/// Of a region's faces: ventricles of a brain open less far to the background, furrows of the study's cortex further.
constexpr double kLeastMouth = 0.05;

} // namespace

std::vector<char> find_outside_of_hull(const CellLabels &cells, const Volume &volume, const Regions &regions,
                                       RegionId background)
{
  const std::vector<double> means = region_means(cells, volume, regions);
  const Surroundings around = surroundings_of(cells, regions, means, background);
  std::vector<char> outside(means.size());
  outside[background] = 1;
  for (RegionId region = 1; region < means.size(); ++region) {
    const double difference = std::abs(means[region] - means[background]);
    const bool is_alike = difference < std::abs(around.means[region] - means[background]) / 2;
    if (is_alike && around.parts[region] >= kLeastMouth)
      outside[region] = 1;
  }
  return outside;
}

} // namespace volsurf
