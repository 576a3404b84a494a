// Maxima of I over squares and cells, and the corners that attain them: step A of the region merge.
//
// Separable: over pairs of samples along x, pairs of those along y, pairs of those along z. The later one must be
// strictly larger, so that of equal samples the one with the lowest linear index wins, as in the sample order. Plain
// loops without branches, made for SIMD.
#pragma once

#include <cstdint>

namespace volsurf {

/// A corner of a cell: bit a is set where the corner is at the cell's high side along axis a.
using CornerCode = std::uint32_t;

/// For 0 <= x < count - 1: the maximum over the samples x, x + 1 of two rows, and its corner (bits 0 and 1).
void square_maxima(const float *row, const float *next_row, std::int64_t count, float *values, CornerCode *corners);

/// For 0 <= i < count: the maximum of two squares, one above the other, and its corner (bits 0, 1 and 2).
void cell_maxima(const float *lower_values, const CornerCode *lower_corners, const float *upper_values,
                 const CornerCode *upper_corners, std::int64_t count, float *values, CornerCode *corners);

} // namespace volsurf
