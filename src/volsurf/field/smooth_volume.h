// A volume between its samples: blurred by a Gaussian, with first and second derivatives at any point.
//
// The samples are blurred by a slightly narrower Gaussian and then taken as the coefficients of cubic B-splines, whose
// own blur (a variance of a third of a voxel's width squared) makes up the rest. So value, gradient and second
// derivatives are continuous and exact derivatives of one another.
//
// Source: Unser, "Splines: a perfect fit for signal and image processing", IEEE Signal Processing Magazine 16 (1999).
#pragma once

#include "volsurf/core/volume.h"

namespace volsurf {

/// Derivatives along the axes of the grid, in intensity per mm and per mm^2.
struct Derivatives {
  Vec3 gradient;
  Vec3 second;       ///< xx, yy, zz
  Vec3 second_mixed; ///< yz, xz, xy
};

/// The blur of the splines by themselves, the square root of 1/3.
constexpr double kLeastBlurVoxels = 0.5773502691896258;

class SmoothVolume {
public:
  /// Blurs by `sigma_mm`, but by no less than kLeastBlurVoxels along each axis. Takes 4 bytes per
  /// sample. Beyond the border the volume continues with its border samples. O(samples * kernel radius), parallel.
  SmoothVolume(const Volume &volume, double sigma_mm);

  const Grid &grid() const { return grid_; }

  /// At a fractional index. Thread-safe; 64 samples are looked at.
  Derivatives derivatives_at(const Vec3 &index) const;

private:
  Grid grid_;
  std::vector<float> coefficients_;
};

} // namespace volsurf
