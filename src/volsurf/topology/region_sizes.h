// How large each basin's region grows.
#pragma once

#include "volsurf/topology/hierarchy.h"

namespace volsurf {

/// Per basin the cells of its region at delta = its persistence, the largest delta at which it has a region of its own.
/// For the basin of infinite persistence all cells. O(basins).
std::vector<std::int64_t> largest_region_sizes(const Hierarchy &hierarchy);

} // namespace volsurf
