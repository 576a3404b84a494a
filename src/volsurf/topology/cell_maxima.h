// Maxima of I over squares and cells: step A of the region merge.
//
// Separable: over pairs of samples along x, pairs of those along y, pairs of those along z. Plain loops without
// branches, made for SIMD.
#pragma once

#include <cstdint>

namespace volsurf {

/// For 0 <= x < count - 1: the maximum over the samples x, x + 1 of two rows.
void square_maxima(const float *row, const float *next_row, std::int64_t count, float *maxima);

/// For 0 <= i < count: the larger of two squares' maxima, one above the other.
void cell_maxima(const float *lower, const float *upper, std::int64_t count, float *maxima);

} // namespace volsurf
