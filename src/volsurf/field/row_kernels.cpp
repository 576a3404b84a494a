#include "volsurf/field/row_kernels.h"

#include "volsurf/core/vectorise.h"

#include <cmath>
#include <limits>

namespace volsurf {

namespace {

constexpr int kVectors = 4;                        // sums that are kept in registers at a time
constexpr std::int64_t kStrip = kLanes * kVectors; // samples in them

VOLSURF_LANES_INLINE const Float32x8 &vector_at(const float *row, std::int64_t i)
{
  return lanes_at<Float32x8>(row + i);
}

} // namespace

VOLSURF_VECTORISE
void smooth_row(KernelRows rows, const float *weights, int radius, std::int64_t count, float *out)
{
  for (std::int64_t i = 0; count < kStrip && i < count; ++i) {
    float sum = weights[0] * rows[radius][i];
    for (int k = 1; k <= radius; ++k)
      sum += weights[k] * (rows[radius - k][i] + rows[radius + k][i]);
    out[i] = sum;
  }
  for (std::int64_t begin = 0; count >= kStrip && begin < count; begin += kStrip) {
    const std::int64_t at = begin + kStrip <= count ? begin : count - kStrip;
    Float32x8 sums[kVectors];
    for (int v = 0; v < kVectors; ++v)
      sums[v] = weights[0] * vector_at(rows[radius], at + kLanes * v);
#pragma GCC unroll 2
    for (int k = 1; k <= radius; ++k)
      for (int v = 0; v < kVectors; ++v)
        sums[v] +=
            weights[k] * (vector_at(rows[radius - k], at + kLanes * v) + vector_at(rows[radius + k], at + kLanes * v));
    for (int v = 0; v < kVectors; ++v)
      lanes_at<Float32x8>(out + at + kLanes * v) = sums[v];
  }
}

VOLSURF_VECTORISE
void derive_row(KernelRows rows, const float *weights, int radius, std::int64_t count, float *out)
{
  for (std::int64_t i = 0; count < kStrip && i < count; ++i) {
    float sum = 0;
    for (int k = 1; k <= radius; ++k)
      sum += weights[k] * (rows[radius + k][i] - rows[radius - k][i]);
    out[i] = sum;
  }
  for (std::int64_t begin = 0; count >= kStrip && begin < count; begin += kStrip) {
    const std::int64_t at = begin + kStrip <= count ? begin : count - kStrip;
    Float32x8 sums[kVectors] = {};
#pragma GCC unroll 2
    for (int k = 1; k <= radius; ++k)
      for (int v = 0; v < kVectors; ++v)
        sums[v] +=
            weights[k] * (vector_at(rows[radius + k], at + kLanes * v) - vector_at(rows[radius - k], at + kLanes * v));
    for (int v = 0; v < kVectors; ++v)
      lanes_at<Float32x8>(out + at + kLanes * v) = sums[v];
  }
}

VOLSURF_VECTORISE
void smooth_and_derive_row(KernelRows rows, const float *smooth, const float *derive, int radius, std::int64_t count,
                           float *smooth_out, float *derive_out)
{
  if (count < kStrip) {
    smooth_row(rows, smooth, radius, count, smooth_out);
    derive_row(rows, derive, radius, count, derive_out);
  }
  for (std::int64_t begin = 0; count >= kStrip && begin < count; begin += kStrip) {
    const std::int64_t at = begin + kStrip <= count ? begin : count - kStrip;
    Float32x8 smooth_sums[kVectors];
    Float32x8 derive_sums[kVectors] = {};
    for (int v = 0; v < kVectors; ++v)
      smooth_sums[v] = smooth[0] * vector_at(rows[radius], at + kLanes * v);
#pragma GCC unroll 2
    for (int k = 1; k <= radius; ++k)
      for (int v = 0; v < kVectors; ++v) {
        const Float32x8 low = vector_at(rows[radius - k], at + kLanes * v);
        const Float32x8 high = vector_at(rows[radius + k], at + kLanes * v);
        smooth_sums[v] += smooth[k] * (low + high);
        derive_sums[v] += derive[k] * (high - low);
      }
    for (int v = 0; v < kVectors; ++v) {
      lanes_at<Float32x8>(smooth_out + at + kLanes * v) = smooth_sums[v];
      lanes_at<Float32x8>(derive_out + at + kLanes * v) = derive_sums[v];
    }
  }
}

VOLSURF_VECTORISE
void difference_row(const float *low, const float *high, float factor, std::int64_t count, float *out)
{
  for (std::int64_t i = 0; i < count; ++i)
    out[i] = (high[i] - low[i]) * factor;
}

VOLSURF_VECTORISE
std::int32_t negative_magnitude_row(const float *gx, const float *gy, const float *gz, std::int64_t count, float *out)
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
