#include "volsurf/topology/cell_maxima.h"

#include "volsurf/core/vectorise.h"

namespace volsurf {

VOLSURF_VECTORISE
void square_maxima(const float *row, const float *next_row, std::int64_t count, float *values, CornerCode *corners)
{
  for (std::int64_t x = 0; x + 1 < count; ++x) {
    const bool right = row[x + 1] > row[x];
    const float low = right ? row[x + 1] : row[x];
    const bool next_right = next_row[x + 1] > next_row[x];
    const float high = next_right ? next_row[x + 1] : next_row[x];
    const bool next = high > low;
    values[x] = next ? high : low;
    const CornerCode low_corner = right ? 1 : 0;
    const CornerCode high_corner = next_right ? 3 : 2;
    corners[x] = next ? high_corner : low_corner;
  }
}

VOLSURF_VECTORISE
void cell_maxima(const float *lower_values, const CornerCode *lower_corners, const float *upper_values,
                 const CornerCode *upper_corners, std::int64_t count, float *values, CornerCode *corners)
{
  for (std::int64_t i = 0; i < count; ++i) {
    const bool upper = upper_values[i] > lower_values[i];
    values[i] = upper ? upper_values[i] : lower_values[i];
    corners[i] = upper ? upper_corners[i] | 4 : lower_corners[i];
  }
}

} // namespace volsurf
