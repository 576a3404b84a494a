// The production merge, seen like the oracle.
#pragma once

#include "support/naive_merge.h"

#include "volsurf/topology/region_merge.h"

#include <algorithm>

namespace volsurf::support {

inline PlaneSource planes_of(const Field &field)
{
  return [&field](std::int64_t z, float *out) {
    const std::int64_t plane = field.size[0] * field.size[1];
    std::copy_n(field.values.begin() + z * plane, plane, out);
  };
}

inline RegionMerge merge_of(const Field &field, Exterior exterior, std::int64_t planes_per_slab)
{
  return merge_regions(field.size, planes_of(field), {exterior, planes_per_slab});
}

/// For each node (cells, then the exterior if there is one) the smallest node of its region.
inline std::vector<std::size_t> partition_of(const RegionMerge &merge, double delta)
{
  const Regions regions = cut(merge.hierarchy, delta);
  std::vector<std::uint32_t> region;
  for (const BasinId basin : merge.cells.basins)
    region.push_back(regions.of_basin[basin]);
  if (merge.hierarchy.exterior)
    region.push_back(regions.of_basin[*merge.hierarchy.exterior]);
  return canonical(region);
}

} // namespace volsurf::support
