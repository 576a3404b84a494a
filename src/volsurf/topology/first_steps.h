// The first face in K of each cell of a row, where the cell's neighbours alone decide it: step B of the region merge.
#pragma once

#include "volsurf/topology/cell_maxima.h"
#include "volsurf/topology/cubical_complex.h"

namespace volsurf {

/// A row of cells with its neighbours. Outside the volume values are +infinity where there is an exterior node and
/// -infinity where there is none, and corners are kNoCorner.
struct CellRow {
  const float *values;
  const CornerCode *corners;
};
constexpr CornerCode kNoCorner = 8;

struct CellRows {
  CellRow centre; ///< readable from -1 to count
  CellRow low_y;
  CellRow high_y;
  CellRow low_z;
  CellRow high_z;
};

/// Let v be a cell's first corner. Among the three neighbours that share v with it and are not newborn at v, the step
/// leads to the one with the largest maximum, ties to the lowest axis; kNoStep where all three are newborn at v, too.
/// Writes step_code(step), eight cells at a time.
void first_steps(const CellRows &rows, std::int64_t count, BasinId *codes);

} // namespace volsurf
