// The first face in K of each cell of a row, where the cell's neighbours alone decide it: step B of the region merge.
//
// In: what is newborn at the row's corners, which tells the first corner of each cell, and I of the cells around. Out:
// a step per cell.
#pragma once

#include "volsurf/topology/newborn.h"

namespace volsurf {

/// I of a row of cells and of those next to it. Outside the volume it is +infinity where there is an exterior node and
/// -infinity where there is none.
struct CellRows {
  const float *level; ///< from -1 on
  const float *low_y;
  const float *high_y;
  const float *low_z;
  const float *high_z;
};

/// The rows of samples at the corners of a row of cells: (y, z), (y + 1, z), (y, z + 1), (y + 1, z + 1).
using CornerRows = std::array<NewbornRow, 4>;

/// Let v be a cell's first corner. Among the three neighbours that share v with it and are not newborn at v, the step
/// leads to the one with the largest maximum, ties to the lowest axis; kNoStep where all three are newborn at v, too.
/// Writes step_code(step) for `count` cells, eight at a time. Reads up to 8 more of each row.
void first_steps(const CellRows &rows, const CornerRows &corners, std::int64_t count, BasinId *codes);

} // namespace volsurf
