#include "volsurf/field/gradient.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"
#include "volsurf/field/kernel_rows.h"
#include "volsurf/field/row_kernels.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace volsurf {

namespace {

int kernel_radius(double sigma_voxels)
{
  return std::max(1, static_cast<int>(std::ceil(4.0 * sigma_voxels)));
}

double gaussian(double sigma, int k)
{
  return std::exp(-0.5 * (k / sigma) * (k / sigma));
}

/// Of all 2 * radius + 1 weights.
double l2_norm(const HalfKernel &kernel)
{
  double sum = static_cast<double>(kernel[0]) * static_cast<double>(kernel[0]);
  for (std::size_t k = 1; k < kernel.size(); ++k)
    sum += 2 * static_cast<double>(kernel[k]) * static_cast<double>(kernel[k]);
  return std::sqrt(sum);
}

/// Memory that a thread uses for some rows after others.
struct RowScratch {
  std::vector<float> smooth_z;                // the rows and those around them, smoothed along z
  std::vector<float> derived_z;               // the same, derived along z
  std::array<std::vector<float>, 3> yz;       // rows done along z and y, padded by the kernel's radius
  std::array<std::vector<float>, 3> gradient; // rows of the three components
};

RowScratch &thread_scratch()
{
  thread_local RowScratch scratch;
  return scratch;
}

/// The neighbours of position i that a difference takes, and what to multiply it by.
struct Difference {
  std::int64_t low;
  std::int64_t high;
  float factor;
};

Difference difference_at(std::int64_t i, std::int64_t size, double spacing_mm)
{
  const std::int64_t low = std::max<std::int64_t>(i - 1, 0);
  const std::int64_t high = std::min(i + 1, size - 1);
  return {low, high, static_cast<float>(1.0 / (static_cast<double>(high - low) * spacing_mm))};
}

/// On a finer grid 0.65 of a voxel is enough for the merge, and thin folds need no more.
double usual_sigma_mm(const Grid &grid)
{
  return (grid.oversampling == 1 ? 1.0 : 0.65 * grid.oversampling) * mean_spacing_mm(grid);
}

double checked_sigma_mm(const Grid &grid, const FieldOptions &options)
{
  const double largest = kLargestSigmaVoxels * smallest_spacing_mm(grid);
  const double sigma = options.sigma_mm.value_or(std::min(usual_sigma_mm(grid), largest));
  if (!(sigma >= 0 && sigma <= largest)) {
    std::ostringstream message;
    message << "--sigma: found " << sigma << "; allowed are 0 to " << largest << " mm (" << kLargestSigmaVoxels
            << " voxels)";
    throw UsageError(message.str());
  }
  return sigma;
}

} // namespace

HalfKernel gaussian_kernel(double sigma_voxels)
{
  const int radius = kernel_radius(sigma_voxels);
  double sum = 1;
  for (int k = 1; k <= radius; ++k)
    sum += 2 * gaussian(sigma_voxels, k);
  HalfKernel weights;
  for (int k = 0; k <= radius; ++k)
    weights.push_back(static_cast<float>(gaussian(sigma_voxels, k) / sum));
  return weights;
}

HalfKernel gaussian_derivative_kernel(double sigma_voxels)
{
  const int radius = kernel_radius(sigma_voxels);
  double moment = 0;
  for (int k = 1; k <= radius; ++k)
    moment += 2.0 * k * k * gaussian(sigma_voxels, k);
  HalfKernel weights;
  for (int k = 0; k <= radius; ++k)
    weights.push_back(static_cast<float>(k * gaussian(sigma_voxels, k) / moment));
  return weights;
}

EdgeField::EdgeField(const Volume &volume, const FieldOptions &options)
    : volume_(volume), edge_map_(options.edge_map),
      sigma_mm_(options.edge_map ? 0 : checked_sigma_mm(volume.grid, options)),
      non_finite_of_row_(
          new std::atomic<std::int32_t>[static_cast<std::size_t>(volume.grid.size[1] * volume.grid.size[2])]())
{
  if (sigma_mm_ == 0)
    return;
  for (int axis = 0; axis < 3; ++axis) {
    const double spacing = volume.grid.spacing_mm[axis];
    kernels_[axis] = {gaussian_kernel(sigma_mm_ / spacing), gaussian_derivative_kernel(sigma_mm_ / spacing)};
    for (float &weight : kernels_[axis].derive)
      weight = static_cast<float>(weight / spacing);
  }
}

void EdgeField::rows(std::int64_t z, const RowRange &rows, float *out) const
{
  const auto &[nx, ny, nz] = volume_.grid.size;
  if (edge_map_)
    negate_row(volume_.samples.data() + (z * ny + rows.begin) * nx, rows.count() * nx, out);
  else if (sigma_mm_ == 0)
    central_difference_rows(z, rows, out);
  else
    gaussian_rows(z, rows, out);
}

PlaneSource EdgeField::planes() const
{
  return [this](std::int64_t z, const RowRange &some, float *out) { rows(z, some, out); };
}

double EdgeField::noise_gain() const
{
  if (edge_map_)
    return 1;
  double largest = 0;
  for (int derived = 0; derived < 3; ++derived) {
    double gain = 1;
    for (int axis = 0; axis < 3; ++axis)
      if (sigma_mm_ > 0)
        gain *= axis == derived ? l2_norm(kernels_[axis].derive) : l2_norm(kernels_[axis].smooth);
      else if (axis == derived)
        gain /= std::sqrt(2.0) * volume_.grid.spacing_mm[axis];
    largest = std::max(largest, gain);
  }
  // As if each of the scan's samples were a cube of those between: its noise is that of all of them.
  return sigma_mm_ > 0 ? largest * std::pow(volume_.grid.oversampling, 1.5) : largest;
}

std::int64_t EdgeField::non_finite_count() const
{
  return std::accumulate(non_finite_of_row_.get(),
                         non_finite_of_row_.get() + volume_.grid.size[1] * volume_.grid.size[2], std::int64_t{0});
}

std::atomic<std::int32_t> &EdgeField::non_finite_of(std::int64_t y, std::int64_t z) const
{
  return non_finite_of_row_[static_cast<std::size_t>(z * volume_.grid.size[1] + y)];
}

void EdgeField::central_difference_rows(std::int64_t z, const RowRange &rows, float *out) const
{
  const auto &[nx, ny, nz] = volume_.grid.size;
  const Vec3 &spacing = volume_.grid.spacing_mm;
  const float *const samples = volume_.samples.data();
  auto &gradient = thread_scratch().gradient;
  for (auto &row : gradient)
    row.resize(static_cast<std::size_t>(nx));
  const Difference dz = difference_at(z, nz, spacing[2]);
  for (std::int64_t y = rows.begin; y < rows.end; ++y, out += nx) {
    const float *const row = samples + (z * ny + y) * nx;
    const Difference inner = difference_at(1, 3, spacing[0]);
    difference_row(row, row + 2, inner.factor, nx - 2, gradient[0].data() + 1);
    for (const std::int64_t x : {std::int64_t{0}, nx - 1}) {
      const Difference dx = difference_at(x, nx, spacing[0]);
      difference_row(row + dx.low, row + dx.high, dx.factor, 1, gradient[0].data() + x);
    }
    const Difference dy = difference_at(y, ny, spacing[1]);
    const float *const plane = samples + z * ny * nx;
    difference_row(plane + dy.low * nx, plane + dy.high * nx, dy.factor, nx, gradient[1].data());
    difference_row(samples + (dz.low * ny + y) * nx, samples + (dz.high * ny + y) * nx, dz.factor, nx,
                   gradient[2].data());
    non_finite_of(y, z) = negative_magnitude_row(gradient[0].data(), gradient[1].data(), gradient[2].data(), nx, out);
  }
}

void EdgeField::gaussian_rows(std::int64_t z, const RowRange &rows, float *out) const
{
  const auto &[nx, ny, nz] = volume_.grid.size;
  const auto &[kx, ky, kz] = kernels_;
  const int rx = static_cast<int>(kx.smooth.size()) - 1;
  const int ry = static_cast<int>(ky.smooth.size()) - 1;
  const int rz = static_cast<int>(kz.smooth.size()) - 1;
  const RowRange around{std::max<std::int64_t>(rows.begin - ry, 0), std::min(rows.end + ry, ny)};
  const std::int64_t last = around.count() - 1;
  RowScratch &scratch = thread_scratch();
  scratch.smooth_z.resize(static_cast<std::size_t>(around.count() * nx));
  scratch.derived_z.resize(static_cast<std::size_t>(around.count() * nx));
  for (auto &row : scratch.yz)
    row.resize(static_cast<std::size_t>(nx + 2 * rx));
  for (auto &row : scratch.gradient)
    row.resize(static_cast<std::size_t>(nx));

  const auto along_z = rows_around(volume_.samples.data() + around.begin * nx, nx * ny, z, nz - 1, rz);
  smooth_and_derive_row(along_z.data(), kz.smooth.data(), kz.derive.data(), rz, around.count() * nx,
                        scratch.smooth_z.data(), scratch.derived_z.data());

  for (std::int64_t y = rows.begin; y < rows.end; ++y, out += nx) {
    const auto smooth_along_y = rows_around(scratch.smooth_z.data(), nx, y - around.begin, last, ry);
    const auto derived_along_y = rows_around(scratch.derived_z.data(), nx, y - around.begin, last, ry);
    smooth_and_derive_row(smooth_along_y.data(), ky.smooth.data(), ky.derive.data(), ry, nx, scratch.yz[0].data() + rx,
                          scratch.yz[1].data() + rx);
    smooth_row(derived_along_y.data(), ky.smooth.data(), ry, nx, scratch.yz[2].data() + rx);
    for (int component = 0; component < 3; ++component) {
      pad_row(scratch.yz[component], rx);
      const auto along_x = shifted_rows(scratch.yz[component].data(), rx);
      float *const result = scratch.gradient[component].data();
      if (component == 0)
        derive_row(along_x.data(), kx.derive.data(), rx, nx, result);
      else
        smooth_row(along_x.data(), kx.smooth.data(), rx, nx, result);
    }
    non_finite_of(y, z) = negative_magnitude_row(scratch.gradient[0].data(), scratch.gradient[1].data(),
                                                 scratch.gradient[2].data(), nx, out);
  }
}

Volume gradient_magnitude(const EdgeField &field, const Grid &grid)
{
  Volume magnitude{grid, std::vector<float>(static_cast<std::size_t>(grid.sample_count()))};
  const std::int64_t plane_size = grid.size[0] * grid.size[1];
  parallel_for_slabs(grid.size[2], 1, [&](const Slab &slab) {
    float *const plane = magnitude.samples.data() + slab.begin * plane_size;
    field.plane(slab.begin, plane);
    negate_row(plane, plane_size, plane);
  });
  return magnitude;
}

} // namespace volsurf
