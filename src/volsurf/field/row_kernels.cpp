#include "volsurf/field/row_kernels.h"

#include "volsurf/core/vectorise.h"

#include <cmath>
#include <limits>

namespace volsurf {

namespace {

/// Samples summed at a time: the sums stay in registers and the first-level cache.
constexpr std::int64_t kStrip = 64;

} // namespace

VOLSURF_VECTORISE
void smooth_row(KernelRows rows, const float *weights, int radius, std::int64_t count, float *out)
{
  for (std::int64_t begin = 0; begin < count; begin += kStrip) {
    const std::int64_t length = count - begin < kStrip ? count - begin : kStrip;
    float sums[kStrip];
    const float *const centre = rows[radius] + begin;
    for (std::int64_t i = 0; i < length; ++i)
      sums[i] = weights[0] * centre[i];
    for (int k = 1; k <= radius; ++k) {
      const float *const low = rows[radius - k] + begin;
      const float *const high = rows[radius + k] + begin;
      const float weight = weights[k];
      for (std::int64_t i = 0; i < length; ++i)
        sums[i] += weight * (low[i] + high[i]);
    }
    for (std::int64_t i = 0; i < length; ++i)
      out[begin + i] = sums[i];
  }
}

VOLSURF_VECTORISE
void derive_row(KernelRows rows, const float *weights, int radius, std::int64_t count, float *out)
{
  for (std::int64_t begin = 0; begin < count; begin += kStrip) {
    const std::int64_t length = count - begin < kStrip ? count - begin : kStrip;
    float sums[kStrip] = {};
    for (int k = 1; k <= radius; ++k) {
      const float *const low = rows[radius - k] + begin;
      const float *const high = rows[radius + k] + begin;
      const float weight = weights[k];
      for (std::int64_t i = 0; i < length; ++i)
        sums[i] += weight * (high[i] - low[i]);
    }
    for (std::int64_t i = 0; i < length; ++i)
      out[begin + i] = sums[i];
  }
}

VOLSURF_VECTORISE
void difference_row(const float *low, const float *high, float factor, std::int64_t count, float *out)
{
  for (std::int64_t i = 0; i < count; ++i)
    out[i] = (high[i] - low[i]) * factor;
}

VOLSURF_VECTORISE
std::int64_t negative_magnitude_row(const float *gx, const float *gy, const float *gz, std::int64_t count, float *out)
{
  constexpr float kLargest = std::numeric_limits<float>::max();
  std::int32_t non_finite = 0;
  for (std::int64_t i = 0; i < count; ++i) {
    const float magnitude = std::sqrt((gx[i] * gx[i] + gy[i] * gy[i]) + gz[i] * gz[i]);
    const bool finite = magnitude <= kLargest;
    non_finite += finite ? 0 : 1;
    out[i] = 0.0F - (finite ? magnitude : kLargest);
  }
  return non_finite;
}

VOLSURF_VECTORISE
void negate_row(const float *in, std::int64_t count, float *out)
{
  for (std::int64_t i = 0; i < count; ++i)
    out[i] = 0.0F - in[i];
}

} // namespace volsurf
