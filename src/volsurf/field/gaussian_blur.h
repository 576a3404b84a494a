// The Gaussian that the gradient is taken with, alone.
#pragma once

#include "volsurf/core/volume.h"

namespace volsurf {

/// The volume's samples after a Gaussian of `sigma_mm`, each axis by its own spacing; 0 leaves them as they are. Beyond
/// the border the volume continues with its border samples. O(samples * kernel radius), parallel. Throws UsageError
/// where sigma_mm is negative, not finite, or wider than kLargestSigmaVoxels.
std::vector<float> gaussian_blur(const Volume &volume, double sigma_mm);

/// The same by a sigma for each axis, in voxels, which the caller has checked; below 0.05 an axis is left as it is.
std::vector<float> gaussian_blur(const Volume &volume, const Vec3 &sigma_voxels);

} // namespace volsurf
