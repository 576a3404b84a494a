// The hierarchy of basins, which answers every delta: step G of the region merge.
//
// In: the tree of basins. Out: one tree as flat arrays. A cut of it at delta is one
// pass over the basins; the cells need not be touched to know the regions.
//
// Source: the paper, algorithm 2; docs/method.md T3 and T4: the younger component of an edge with persistence < delta
// is one region by the time of the edge, so the tree needs one entry per basin, for the edge at which it stops to be a
// component.
#pragma once

#include "volsurf/topology/join_saddles.h"

#include <optional>

namespace volsurf {

/// All arrays but by_rank are indexed by BasinId.
struct Hierarchy {
  std::vector<float> persistence;  ///< of the edge at which the basin joins an elder one; +infinity for one basin
  std::vector<BasinId> ancestor;   ///< first basin of earlier rank on the way to the elder side; itself at the top
  std::vector<BasinId> by_rank;    ///< basins by decreasing persistence, ties by id
  std::vector<std::uint32_t> rank; ///< the inverse of by_rank
  std::vector<CellId> roots;       ///< the cell of largest I, -1 for the exterior
  std::vector<float> values;       ///< its I
  std::vector<std::int64_t> cell_counts;
  std::optional<BasinId> exterior; ///< the basin that holds the exterior node
  BasinId background = 0;          ///< its region, at any delta, is the background (background.h)

  std::size_t basin_count() const { return persistence.size(); }

  /// The number of regions at a delta > 0: 1 + #{persistence >= delta} over the finite ones (T4). O(log basins).
  std::size_t region_count(double delta) const;

  /// The largest finite persistence, 0 where there is one basin only.
  float largest_persistence() const { return by_rank.size() > 1 ? persistence[by_rank[1]] : 0.0F; }
};

/// Takes the arrays of `basins` but its labels, and those of the tree. O(basins log basins), and O(basins) where ways
/// in the tree are as short as those in volumes (elder_ancestors.h).
Hierarchy make_hierarchy(Basins &basins, BasinTree &tree, Exterior exterior);

/// The regions at one delta.
struct Regions {
  std::vector<RegionId> of_basin;        ///< per basin, 1 .. count
  std::vector<BasinId> maxima;           ///< per region id - 1: the basin of its maximum, the only one with
                                         ///< persistence >= delta
  std::vector<std::int64_t> cell_counts; ///< per region id - 1, decreasing

  std::size_t count() const { return maxima.size(); }
};

/// Regions are numbered by decreasing number of cells, ties by root cell. delta must be > 0. O(basins).
Regions cut(const Hierarchy &hierarchy, double delta);

/// The earliest rank on the path between two basins in the tree, its top left out: they are in two regions exactly
/// where more than that many basins survive. The number of basins for a == b. O(ancestors).
std::uint32_t joined_at_rank(const Hierarchy &hierarchy, BasinId a, BasinId b);

/// The largest persistence on the path between two basins in the tree: they are in one region for every larger delta,
/// and in two for every other. 0 for a == b. O(ancestors).
float saliency(const Hierarchy &hierarchy, BasinId a, BasinId b);

} // namespace volsurf
