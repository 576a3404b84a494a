// Boxes of cells: a region's surface is made within the region's own box, so that many small ones cost no more than the
// volume.
#pragma once

#include "volsurf/core/cell_labels.h"

#include <vector>

namespace volsurf {

/// Cells from `low` up to but not including `high`.
struct CellBox {
  Index3 low{0, 0, 0};
  Index3 high{0, 0, 0};

  Index3 size() const { return {high[0] - low[0], high[1] - low[1], high[2] - low[2]}; }
};

/// The smallest box around the cells of each region, and one cell more on each side as far as the volume goes. In the
/// order of `wanted`, which ascends; a region without cells has an empty box. Parallel, O(cells).
std::vector<CellBox> boxes_around(const CellLabels &cells, const std::vector<RegionId> &region_of_basin,
                                  const std::vector<RegionId> &wanted);

/// The cells of a box, and the grid of the samples at their corners.
CellLabels cells_in(const CellBox &box, const CellLabels &cells);
Grid grid_in(const CellBox &box, const Grid &grid);

} // namespace volsurf
