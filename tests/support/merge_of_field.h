// The production merge, seen like the oracle.
#pragma once

#include "support/naive_merge.h"

#include "volsurf/topology/region_merge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace volsurf::support {

inline PlaneSource planes_of(const Field &field)
{
  return [&field](std::int64_t z, const RowRange &rows, float *out) {
    const auto &[nx, ny, nz] = field.size;
    std::copy_n(field.values.begin() + (z * ny + rows.begin) * nx, rows.count() * nx, out);
  };
}

inline RegionMerge merge_of(const Field &field, Exterior exterior, const TileSize &tile = {2, 2})
{
  return merge_regions(field.size, planes_of(field), {exterior, tile});
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

/// Each persistence, the next float above it, and the ends: the deltas at which a partition may change.
inline std::vector<float> deltas_that_matter(const std::multiset<float> &persistences)
{
  std::set<float> deltas{std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max()};
  for (const float persistence : persistences) {
    deltas.insert(persistence);
    deltas.insert(std::nextafter(persistence, std::numeric_limits<float>::infinity()));
  }
  return {deltas.begin(), deltas.end()};
}

inline std::multiset<float> positive_persistences(const std::vector<TreeEdge> &tree)
{
  std::multiset<float> result;
  for (const TreeEdge &edge : tree)
    if (edge.persistence > 0)
      result.insert(edge.persistence);
  return result;
}

inline std::multiset<float> positive_persistences(const Hierarchy &hierarchy)
{
  std::multiset<float> result;
  for (const float persistence : hierarchy.persistence)
    if (persistence > 0 && std::isfinite(persistence))
      result.insert(persistence);
  return result;
}

} // namespace volsurf::support
