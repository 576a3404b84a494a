// Islands: what is not background, in parts that hang together over faces of cells.
#pragma once

#include "volsurf/core/cell_labels.h"

#include <vector>

namespace volsurf {

/// The island of each region, indexed by region id: the smallest id of a region in it, kNoRegion for the background and
/// for index 0. A region lies within one island, since its cells hang together. `regions` is their number. O(cells).
std::vector<RegionId> find_islands(const CellLabels &cells, const std::vector<RegionId> &region_of_basin,
                                   std::size_t regions, RegionId background);

} // namespace volsurf
