// What the surface of a run is to separate.
#pragma once

#include "volsurf/pipeline/settings.h"
#include "volsurf/surface/boundary.h"
#include "volsurf/topology/region_merge.h"

namespace volsurf {

struct Selection {
  Sides sides;
  bool one_thing; ///< the surface goes around one side only, so that it can be made a manifold
};

/// The sides that --surface and --seed ask for. Throws UsageError where a seed lies outside the volume.
Selection select_sides(const Settings &settings, const Grid &grid, const RegionMerge &merge, const Regions &regions,
                       RegionId background);

} // namespace volsurf
