// The intensities on the two sides of a wall, from the samples around.
//
// Near a wall a scan is one intensity outside and another inside, and inside it may be a third beyond a layer next to
// the wall: grey matter is a layer over white matter, skin over fat. A sample is a mixture of the three by the parts
// that its voxel has of them, so linear regression over the parts tells them. Without the third the layer's intensity
// is drawn to what lies beyond, and the wall with it: on the study's head by a tenth of a voxel. Outside there is no
// layer: with one on both sides little would hold the wall, and with one there alone white matter grows spikes.
//
// In: a scan model with a surface. Out: at any place the intensities. Guarantees: no thread count changes a byte.
// Passes: the sums that a regression needs, over blocks of samples; the sums blurred across blocks, along each axis; at
// a place, the regression on the sums interpolated between blocks. So the samples around are looked at once for all
// places, not once for each.
#pragma once

#include "volsurf/surface/scan_model.h"

#include <array>
#include <optional>

namespace volsurf {

/// The intensities that fit best.
struct Contrast {
  double outside = 0;   ///< next to the wall
  double step = 0;      ///< inside, next to the wall, less outside
  double beyond = 0;    ///< beyond a layer inside less within it
  double left_over = 0; ///< sd of the samples from the mixture
};

/// Regressions over the samples around any place, weighed by a Gaussian of about three voxels.
class WallContrasts {
public:
  /// O(samples), parallel; takes 3 bytes per sample.
  explicit WallContrasts(const ScanModel &model);

  /// Nothing where no wall is near, or the scan is flat. O(1).
  std::optional<Contrast> at(const Vec3 &place) const;

private:
  /// Sums over samples of products of two of these: 1, the part inside, the part beyond the layer, the intensity.
  using Sums = std::array<double, 10>;

  std::size_t index_of(const Index3 &block) const
  {
    return static_cast<std::size_t>(block[0] + size_[0] * (block[1] + size_[1] * block[2]));
  }

  static Sums sums_of_block(const ScanModel &model, const Index3 &block);
  void blur_along(int axis);
  Sums sums_around(const Vec3 &place) const;

  Index3 size_; ///< blocks
  std::vector<Sums> blocks_;
};

} // namespace volsurf
