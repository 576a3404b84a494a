// What a kernel along an axis sees of a volume.
#pragma once

#include "volsurf/field/gradient.h"

#include <algorithm>
#include <numeric>

namespace volsurf {

/// Half the width of the widest kernel, in samples.
constexpr int kLargestRadius = static_cast<int>(4 * kLargestSigmaVoxels);

/// Rows at equal distances from each other.
using RowPointers = std::array<const float *, 2 * kLargestRadius + 1>;

/// The rows that start at first, first + stride, ...; positions beyond 0 .. last are taken at the border.
inline RowPointers rows_around(const float *first, std::int64_t stride, std::int64_t centre, std::int64_t last,
                               int radius)
{
  RowPointers rows;
  for (int k = -radius; k <= radius; ++k)
    rows[static_cast<std::size_t>(k) + static_cast<std::size_t>(radius)] =
        first + std::clamp<std::int64_t>(centre + k, 0, last) * stride;
  return rows;
}

/// Shifted views of a padded row: what a kernel along the row itself sees.
inline RowPointers shifted_rows(const float *padded, int radius)
{
  RowPointers rows;
  std::iota(rows.begin(), rows.begin() + 2 * radius + 1, padded);
  return rows;
}

/// Continues a row's border samples into the `radius` places before and after it.
inline void pad_row(std::vector<float> &row, int radius)
{
  std::fill_n(row.begin(), radius, row[static_cast<std::size_t>(radius)]);
  std::fill_n(row.rbegin(), radius, *(row.rbegin() + radius));
}

} // namespace volsurf
