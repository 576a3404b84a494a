// The nearest stronger basin on each basin's way to the elder side: part of step G of the region merge.
//
// In: for each basin the basin at the elder side of the edge at which it joined, which links them to a tree. Out: for
// each the first one of earlier rank on the way up that tree.
//
// Passes: slabs of basins climb at once, by number, since basins of neighbouring numbers are near each other in memory
// as in the volume, and all shorten the ways of those that they pass. Should that take a slab too long, what it has
// left is climbed by rank.
#pragma once

#include "volsurf/core/ids.h"

#include <vector>

namespace volsurf {

/// Puts the ancestors in place of the elder sides; the top of the tree, which is of the first rank, is its own. `rank`
/// is the inverse of `by_rank`. O(basins log basins) at the most.
void find_elder_ancestors(const std::vector<BasinId> &by_rank, const std::vector<std::uint32_t> &rank,
                          std::vector<BasinId> &elder_side);

} // namespace volsurf
