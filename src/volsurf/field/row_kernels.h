// The arithmetic of the gradient on rows of samples: plain loops without branches, made for SIMD.
#pragma once

#include <cstdint>

namespace volsurf {

/// The 2 * radius + 1 rows that a kernel sees: rows[radius] is the centre. Along x they are one row, shifted.
using KernelRows = const float *const *;

/// out[i] = w[0] c[i] + sum over k of w[k] (rows[radius - k][i] + rows[radius + k][i]).
void smooth_row(KernelRows rows, const float *weights, int radius, std::int64_t count, float *out);

/// out[i] = sum over k of w[k] (rows[radius + k][i] - rows[radius - k][i]).
void derive_row(KernelRows rows, const float *weights, int radius, std::int64_t count, float *out);

/// Both at once, which loads the rows once.
void smooth_and_derive_row(KernelRows rows, const float *smooth, const float *derive, int radius, std::int64_t count,
                           float *smooth_out, float *derive_out);

/// out[i] = (high[i] - low[i]) * factor.
void difference_row(const float *low, const float *high, float factor, std::int64_t count, float *out);

/// out[i] = -sqrt((gx gx + gy gy) + gz gz), the most negative finite float where that is not finite. Returns the number
/// of those.
std::int32_t negative_magnitude_row(const float *gx, const float *gy, const float *gz, std::int64_t count, float *out);

/// out[i] = 0 - in[i], which is never -0.
void negate_row(const float *in, std::int64_t count, float *out);

} // namespace volsurf
