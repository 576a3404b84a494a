#include "volsurf/field/smooth_volume.h"

#include "volsurf/field/gaussian_blur.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

/// Four B-splines that overlap at a point, with their derivatives, and the samples that they belong to.
struct SplineWeights {
  SplineWeights(double position, std::int64_t size)
  {
    const double clamped = std::clamp(position, 0.0, static_cast<double>(size - 1));
    const double floor = std::floor(clamped);
    const double t = clamped - floor;
    const double u = 1 - t;
    value = {u * u * u / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * u * u * u - 6 * u * u + 4) / 6, t * t * t / 6};
    first = {-u * u / 2, (3 * t * t - 4 * t) / 2, (4 * u - 3 * u * u) / 2, t * t / 2};
    second = {u, 3 * t - 2, 3 * u - 2, t};
    for (int k = 0; k < 4; ++k)
      samples[k] = std::clamp<std::int64_t>(static_cast<std::int64_t>(floor) + k - 1, 0, size - 1);
  }

  std::array<double, 4> value;
  std::array<double, 4> first;
  std::array<double, 4> second;
  std::array<std::int64_t, 4> samples;
};

/// The blur that is left when the splines have done theirs.
double remaining_sigma_voxels(double sigma_mm, double spacing_mm)
{
  const double sigma = sigma_mm / spacing_mm;
  return std::sqrt(std::max(sigma * sigma - kLeastBlurVoxels * kLeastBlurVoxels, 0.0));
}

double sum(const std::array<double, 4> &weights, const std::array<double, 4> &values)
{
  return weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2] + weights[3] * values[3];
}

} // namespace

SmoothVolume::SmoothVolume(const Volume &volume, double sigma_mm) : grid_(volume.grid)
{
  Vec3 sigma_voxels{};
  for (int axis = 0; axis < 3; ++axis)
    sigma_voxels[axis] = remaining_sigma_voxels(sigma_mm, grid_.spacing_mm[axis]);
  coefficients_ = gaussian_blur(volume, sigma_voxels);
}

Derivatives SmoothVolume::derivatives_at(const Vec3 &index) const
{
  const auto &[nx, ny, nz] = grid_.size;
  const SplineWeights wx(index[0], nx);
  const SplineWeights wy(index[1], ny);
  const SplineWeights wz(index[2], nz);
  // Along x, then y: named by the order of the derivatives along x and y.
  std::array<double, 4> d00{};
  std::array<double, 4> d10{};
  std::array<double, 4> d20{};
  std::array<double, 4> d01{};
  std::array<double, 4> d11{};
  std::array<double, 4> d02{};
  for (int k = 0; k < 4; ++k) {
    std::array<double, 4> d0{};
    std::array<double, 4> d1{};
    std::array<double, 4> d2{};
    for (int j = 0; j < 4; ++j) {
      const float *const row = coefficients_.data() + (wz.samples[k] * ny + wy.samples[j]) * nx;
      std::array<double, 4> samples{};
      for (int i = 0; i < 4; ++i)
        samples[i] = static_cast<double>(row[wx.samples[i]]);
      d0[j] = sum(wx.value, samples);
      d1[j] = sum(wx.first, samples);
      d2[j] = sum(wx.second, samples);
    }
    d00[k] = sum(wy.value, d0);
    d10[k] = sum(wy.value, d1);
    d20[k] = sum(wy.value, d2);
    d01[k] = sum(wy.first, d0);
    d11[k] = sum(wy.first, d1);
    d02[k] = sum(wy.second, d0);
  }
  const auto &[hx, hy, hz] = grid_.spacing_mm;
  return {{sum(wz.value, d10) / hx, sum(wz.value, d01) / hy, sum(wz.first, d00) / hz},
          {sum(wz.value, d20) / (hx * hx), sum(wz.value, d02) / (hy * hy), sum(wz.second, d00) / (hz * hz)},
          {sum(wz.first, d01) / (hy * hz), sum(wz.first, d10) / (hx * hz), sum(wz.value, d11) / (hx * hy)}};
}

} // namespace volsurf
