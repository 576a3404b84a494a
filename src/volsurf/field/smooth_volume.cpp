#include "volsurf/field/smooth_volume.h"

#include "volsurf/core/parallel.h"
#include "volsurf/field/kernel_rows.h"
#include "volsurf/field/row_kernels.h"

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
  return std::sqrt(std::max(sigma * sigma - 1.0 / 3.0, 0.0));
}

HalfKernel blur_kernel(double sigma_voxels)
{
  return sigma_voxels > 0.05 ? gaussian_kernel(sigma_voxels) : HalfKernel{1.0F};
}

/// Blurs along z, then y, then x, into `out`.
void blur(const Volume &volume, const std::array<HalfKernel, 3> &kernels, std::vector<float> &out)
{
  const auto &[nx, ny, nz] = volume.grid.size;
  const auto radius = [&](int axis) { return static_cast<int>(kernels[axis].size()) - 1; };
  parallel_for_slabs(nz, 1, [&, nx = nx, ny = ny, nz = nz](const Slab &slab) {
    const std::int64_t z = slab.begin;
    std::vector<float> plane(static_cast<std::size_t>(nx * ny));
    std::vector<float> row(static_cast<std::size_t>(nx + 2 * radius(0)));
    const auto along_z = rows_around(volume.samples.data(), nx * ny, z, nz - 1, radius(2));
    smooth_row(along_z.data(), kernels[2].data(), radius(2), nx * ny, plane.data());
    for (std::int64_t y = 0; y < ny; ++y) {
      const auto along_y = rows_around(plane.data(), nx, y, ny - 1, radius(1));
      smooth_row(along_y.data(), kernels[1].data(), radius(1), nx, row.data() + radius(0));
      pad_row(row, radius(0));
      const auto along_x = shifted_rows(row.data(), radius(0));
      smooth_row(along_x.data(), kernels[0].data(), radius(0), nx, out.data() + (z * ny + y) * nx);
    }
  });
}

double sum(const std::array<double, 4> &weights, const std::array<double, 4> &values)
{
  return weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2] + weights[3] * values[3];
}

} // namespace

SmoothVolume::SmoothVolume(const Volume &volume, double sigma_mm)
    : grid_(volume.grid), coefficients_(volume.samples.size())
{
  std::array<HalfKernel, 3> kernels;
  for (int axis = 0; axis < 3; ++axis)
    kernels[axis] = blur_kernel(remaining_sigma_voxels(sigma_mm, grid_.spacing_mm[axis]));
  blur(volume, kernels, coefficients_);
}

Vec3 SmoothVolume::gradient_at(const Vec3 &index) const
{
  return derivatives_at(index).gradient;
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
