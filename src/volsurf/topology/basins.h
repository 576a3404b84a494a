// Basins, the trees of steps: step D of the region merge.
//
// In: the steps of a sweep. Out: the basin of each cell.
//
// Guarantees: basins are numbered by root cell. Passes: each slab of cells turns its steps into labels, in one pass
// forward and one backward; the paths that left it are joined up over the slabs; then the runs of cells on them get
// their labels.
#pragma once

#include "volsurf/topology/star_sweep.h"

namespace volsurf {

struct Basins {
  Buffer<BasinId> labels;                ///< per cell
  std::vector<CellId> roots;             ///< per basin, ascending; the exterior's basin, if any, is the last and has -1
  std::vector<float> values;             ///< I of the root, +infinity for the exterior
  std::vector<std::int64_t> cell_counts; ///< per basin
};

/// Takes the sweep's codes, which become the labels, and its roots. O(cells). Throws Error where there are more than
/// 2^31 basins.
Basins label_basins(const CellGrid &cells, StarSweep &sweep, Exterior exterior, std::int64_t planes_per_slab);

} // namespace volsurf
