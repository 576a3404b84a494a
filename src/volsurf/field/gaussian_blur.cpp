#include "volsurf/field/gaussian_blur.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"
#include "volsurf/field/kernel_rows.h"
#include "volsurf/field/row_kernels.h"

#include <cmath>

namespace volsurf {

namespace {

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

} // namespace

std::vector<float> gaussian_blur(const Volume &volume, double sigma_mm)
{
  Vec3 sigma_voxels{};
  for (int axis = 0; axis < 3; ++axis) {
    sigma_voxels[axis] = sigma_mm / volume.grid.spacing_mm[axis];
    if (!(sigma_voxels[axis] >= 0 && sigma_voxels[axis] <= kLargestSigmaVoxels))
      throw UsageError("blur: " + std::to_string(sigma_mm) + " mm, must lie in 0 .. " +
                       std::to_string(static_cast<int>(kLargestSigmaVoxels)) + " voxels");
  }
  return gaussian_blur(volume, sigma_voxels);
}

std::vector<float> gaussian_blur(const Volume &volume, const Vec3 &sigma_voxels)
{
  std::vector<float> blurred(volume.samples.size());
  blur(volume, {blur_kernel(sigma_voxels[0]), blur_kernel(sigma_voxels[1]), blur_kernel(sigma_voxels[2])}, blurred);
  return blurred;
}

} // namespace volsurf
