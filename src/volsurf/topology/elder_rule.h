// Kruskal with the elder rule over edges between basins: step F of the region merge, a block of planes at a time.
//
// In: the edges of a block, sorted. Out: where basins join elder ones, as far as the block decides it, and the edges
// that are left.
//
// Guarantee: what all blocks leave, sorted and joined as one block, gives the tree of a Kruskal over all edges. A basin
// is closed if it has no edges but those of the block. A component of closed basins is, whenever it meets an edge, what
// it is in the Kruskal over all edges. So where it is the younger one its end is final, since the other side can only
// be elder than the block knows, and it may be contracted into that side at once: it has no edges of other blocks that
// could tell. An edge that closes a cycle in the block closes one of edges that come earlier in K.
#pragma once

#include "volsurf/core/ids.h"

#include <vector>

namespace volsurf {

/// A saddle face, seen as an edge between two basins.
struct SaddleEdge {
  float value; ///< I of the face
  BasinId a;
  BasinId b;
};

/// Half-open range of basins.
struct BasinRange {
  BasinId begin;
  BasinId end;

  bool contains(BasinId basin) const { return basin >= begin && basin < end; }
  std::size_t count() const { return end - begin; }
};

/// The basins at a block's edges.
struct BasinBlock {
  BasinRange basins;              ///< nearly all of them; edges to others are left
  std::vector<std::uint8_t> open; ///< per basin of the range: 1 where it may have edges of other blocks
};

/// Per basin, how it joined an elder one.
struct BasinTree {
  explicit BasinTree(std::size_t basins);

  std::vector<float> persistence;  ///< of the edge at which it did; +infinity where it has not
  std::vector<BasinId> elder_side; ///< the basin at the other end of that edge; itself
  std::vector<BasinId> elder;      ///< the eldest basin of the component that it joined; itself
};

/// Joins basins of a block over its edges and removes the edges that are done with. `values` are the basins' maxima.
/// Touches nothing of the tree but entries of closed basins, so that blocks can be joined in parallel. O(edges + basins
/// of the block).
void join_basins(const std::vector<float> &values, BasinBlock block, std::vector<SaddleEdge> &edges, BasinTree &tree);

} // namespace volsurf
