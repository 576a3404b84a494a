#include "volsurf/topology/cell_maxima.h"

#include "volsurf/core/vectorise.h"

#include <algorithm>

namespace volsurf {

VOLSURF_VECTORISE
void square_maxima(const float *row, const float *next_row, std::int64_t count, float *maxima)
{
  for (std::int64_t x = 0; x + 1 < count; ++x)
    maxima[x] = std::max(std::max(row[x], row[x + 1]), std::max(next_row[x], next_row[x + 1]));
}

VOLSURF_VECTORISE
void cell_maxima(const float *lower, const float *upper, std::int64_t count, float *maxima)
{
  for (std::int64_t i = 0; i < count; ++i)
    maxima[i] = std::max(lower[i], upper[i]);
}

} // namespace volsurf
