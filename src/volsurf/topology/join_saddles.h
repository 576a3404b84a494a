// The tree of basins: steps E and F of the region merge.
//
// In: the basins and the saddle faces of a sweep, each of which is an edge between two basins. Out: where each basin
// joins an elder one.
//
// Guarantee: the tree of a Kruskal over all edges in order K. Passes: runs of planes whose edges stay in the cache,
// blocks of runs, then the volume. Each sorts and joins what those before have left; runs and blocks do so in parallel,
// and only about one edge in a hundred is left for the last pass.
#pragma once

#include "volsurf/topology/basins.h"
#include "volsurf/topology/elder_rule.h"

namespace volsurf {

/// Empties the sweep's saddles. Blocks have at most `planes_per_block` planes; they do not change the result.
/// O(saddles + basins).
BasinTree join_saddles(const CellGrid &cells, const Basins &basins, StarSweep &sweep, std::int64_t planes_per_block);

} // namespace volsurf
