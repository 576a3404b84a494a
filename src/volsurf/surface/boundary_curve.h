// What the boundary E(delta) is at every delta at once: regions, faces, area and components, without a cut for each.
//
// In: the basins of the cells, and for any two basins the rank at which they are joined. Out: four curves over delta.
// A face between basins a and b is in E(delta) exactly where a and b are in two regions (docs/method.md T6), so it is
// born at one rank and never dies as delta decreases: its numbers are cumulative sums over ranks, and its components
// those of a graph whose vertices (faces) and edges (two faces at an edge of the grid) appear in the order of ranks.
// Passes: each slab contracts faces of one rank that share edges to patches and keeps a minimum spanning forest of the
// junctions between these; the slabs' forests are joined over their seams; one Kruskal over the junctions that are
// left, by rank.
#pragma once

#include "volsurf/core/cell_labels.h"
#include "volsurf/core/progress.h"

#include <array>
#include <functional>
#include <vector>

namespace volsurf {

/// What the curve needs to know of a hierarchy of basins. Basins have ranks from 0, by decreasing persistence; those of
/// persistence >= delta survive at delta.
struct BasinRanks {
  std::vector<float> persistence; ///< per rank, decreasing, positive or 0; the first is infinite
  BasinId background = 0;         ///< what lies outside the volume counts as part of it

  /// Two different basins are in two regions exactly where more than this number of basins survive, 1 .. basins - 1.
  /// Called from several threads.
  std::function<std::uint32_t(BasinId, BasinId)> joined_at;
};

/// Arrays are per rank r, for the r + 1 regions where basins of rank 0 .. r survive. At each delta, 0 < delta, the
/// numbers are those of find_boundary and find_components with each region a side of its own. Queries are
/// O(log(basins)).
struct BoundaryCurve {
  std::vector<float> persistence; ///< the largest delta with that many regions; not increasing, the first is infinite
  std::vector<std::array<std::int64_t, 3>> faces_of_axis; ///< those at the border of the volume included
  std::vector<std::int64_t> components;                   ///< connected over shared edges
  std::array<double, 3> face_area_mm2{};                  ///< per axis

  std::size_t regions_at(double delta) const;
  std::int64_t faces_at(double delta) const;
  double area_at(double delta) const; ///< mm^2
  std::int64_t components_at(double delta) const;
};

/// `grid` is that of the samples. Parallel; O(cells + faces between basins * ancestors). Memory: 0.6 bytes per sample,
/// 8 per face between basins in the slabs that are at work, and about 60 per patch, of which there are about as many as
/// pairs of neighbouring basins. Throws Cancelled.
BoundaryCurve find_boundary_curve(const CellLabels &cells, const Grid &grid, const BasinRanks &ranks,
                                  const Progress &progress = {});

} // namespace volsurf
