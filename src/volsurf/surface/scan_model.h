// What a closed surface says of the scan around it, and how far that is from what the scan is.
//
// Of each voxel the surface tells the part that is inside. Near a wall the samples are a straight line over that part,
// whose two ends are the intensities outside and inside; what they have more or less than the line says moves the wall.
//
// In: samples, and the parts of voxels (voxel_shares.h), of a window of the scan. Places are fractional indices in the
// window. Weights are Gaussians in voxels, cut at three voxels. The outermost samples of a scan weigh nothing, since
// the caps of surfaces cut their voxels in two.
#pragma once

#include "volsurf/core/mesh.h"
#include "volsurf/core/volume.h"

#include <optional>

namespace volsurf {

/// Of all samples of a scan those in a box.
struct Window {
  Index3 begin{0, 0, 0};
  Grid grid;      ///< of the window
  Index3 of_scan; ///< samples of the whole scan
};

/// A number per sample of a window. Rows are padded by kPadding at both ends.
struct PaddedRows {
  static constexpr std::int64_t kPadding = 8;

  const float *row(std::int64_t y, std::int64_t z) const
  {
    return values.data() + (z * size[1] + y) * (size[0] + 2 * kPadding) + kPadding;
  }

  Index3 size;
  std::vector<float> values;
};

/// A scan, and what a surface makes of it. Takes 8 bytes per sample.
struct ScanModel {
  /// Without shares yet. Of a volume that may be oversampled the scan's own samples are taken.
  ScanModel(const Window &window, const Volume &volume);

  void set_surface(const Mesh &mesh);

  Window window;
  PaddedRows samples;
  PaddedRows shares;
};

/// The intensities that fit best on the two sides of a wall.
struct Contrast {
  double outside = 0;
  double step = 0;      ///< inside less outside
  double left_over = 0; ///< sd of the samples from the line
};

/// By linear regression over the samples around; nothing where no wall is near, or the scan is flat.
std::optional<Contrast> contrast_around(const Vec3 &place, const ScanModel &model);

/// How far out the wall at a place should be, and the sd of that, both in voxels.
struct Mismatch {
  double way = 0;   ///< at most 1
  double error = 0; ///< at most 3
};

/// From the samples next to a place on the surface, each with the sd `noise`. Nothing where there is none.
std::optional<Mismatch> mismatch_at(const Vec3 &place, const Contrast &contrast, double noise, const ScanModel &model);

} // namespace volsurf
