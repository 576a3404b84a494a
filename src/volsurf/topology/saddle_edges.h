// The graph that is left when basins are contracted: step E of the region merge, and what of F needs no other slab.
//
// In: the basins and the saddle faces of a sweep. Out: edges among which are all those of the tree of basins; hardly
// more than there are basins (0.02 per sample in noise, 0.009 in a scan), where saddle faces are four to five times as
// many.
//
// Guarantee: a Kruskal over some of the edges leaves out only what the one over all rejects, too, since the other edges
// of a cycle that an edge closes come earlier in K. So most of them are sorted and judged in parallel, in runs that
// stay in the cache.
#pragma once

#include "volsurf/topology/basins.h"

namespace volsurf {

/// A saddle face, seen as an edge between two basins.
struct SaddleEdge {
  float value; ///< I of the face
  BasinId a;
  BasinId b;
};

/// Saddle faces between different basins, those of equal value in the order K. Empties the sweep's saddles.
std::vector<SaddleEdge> saddle_edges(const CellGrid &cells, const Basins &basins, StarSweep &sweep);

/// Sorts edges by decreasing value; those of equal value keep their order.
void sort_edges(std::vector<SaddleEdge> &edges);

} // namespace volsurf
