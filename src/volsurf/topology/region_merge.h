// The region merge: from the field to the hierarchy of basins.
//
// In: I = -|grad g| on the samples, plane by plane. Out: the basin of each cell and the hierarchy that joins basins to
// regions for any delta. For every delta > 0 the partition is the one of Kruskal over all faces in order K
// (docs/method.md sections 2 and 4), without sorting or storing a face.
//
// Source: the paper, algorithm 2. Steps: star_sweep (A, B, C), basins (D), join_saddles (E, F), hierarchy (G).
#pragma once

#include "volsurf/core/cell_labels.h"
#include "volsurf/topology/hierarchy.h"

#include <optional>

namespace volsurf {

struct MergeOptions {
  Exterior exterior = Exterior::none;
  std::optional<TileSize> tile = {}; ///< the threads' work; does not change the result
};

struct RegionMerge {
  CellLabels cells;
  Hierarchy hierarchy;
};

/// `samples` has at least 2 samples per axis. Uses 8 to 12 bytes per sample. Throws Cancelled.
RegionMerge merge_regions(const Index3 &samples, const PlaneSource &field, const MergeOptions &options,
                          const Progress &progress = {});

} // namespace volsurf
