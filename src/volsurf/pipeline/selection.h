// What the surface of a run is to separate.
#pragma once

#include "volsurf/pipeline/settings.h"
#include "volsurf/surface/boundary.h"
#include "volsurf/topology/region_merge.h"

namespace volsurf {

struct Selection {
  std::vector<RegionId> regions; ///< those that were asked for, ascending; not empty
  Sides sides;
  bool one_thing; ///< the surface goes around one side only, so that it can be made a manifold
};

/// The regions and sides that --surface, --seed, --region and --min-volume ask for. Throws UsageError where a seed lies
/// outside the volume or a region does not exist, and EmptyResult where nothing is as large as --min-volume. O(basins),
/// for a hull O(cells).
Selection select_sides(const Settings &settings, const Volume &volume, const Grid &grid, const RegionMerge &merge,
                       const Regions &regions, RegionId background);

} // namespace volsurf
