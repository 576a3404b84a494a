// The basin of each cell: what the merge hands to the surface stages.
#pragma once

#include "volsurf/core/buffer.h"
#include "volsurf/core/grid.h"

namespace volsurf {

/// One basin per cell of a cell grid of the given size, x fastest.
struct CellLabels {
  Index3 size{0, 0, 0};
  Buffer<BasinId> basins;
};

} // namespace volsurf
