// A scan, and what a closed surface makes of it: of each voxel the part that is inside, and the part that is beyond a
// layer next to the surface.
//
// In: samples of a window of the scan; a mesh. Places are fractional indices in the window.
#pragma once

#include "volsurf/core/mesh.h"
#include "volsurf/core/volume.h"

#include <cstdint>
#include <vector>

namespace volsurf {

/// Of all samples of a scan those in a box.
struct Window {
  /// The outermost samples of a scan do not count, since the caps of surfaces cut their voxels in two.
  std::int64_t first_that_counts(int axis) const { return begin[axis] == 0 ? 1 : 0; }
  std::int64_t end_of_those_that_count(int axis) const
  {
    return grid.size[axis] - (begin[axis] + grid.size[axis] == of_scan[axis] ? 1 : 0);
  }

  Index3 begin{0, 0, 0};
  Grid grid;      ///< of the window
  Index3 of_scan; ///< samples of the whole scan
};

/// A number per sample of a window. Rows are padded by kPadding at both ends.
struct PaddedRows {
  static constexpr std::int64_t kPadding = 8;

  explicit PaddedRows(const Index3 &size);

  const float *row(std::int64_t y, std::int64_t z) const { return values.data() + begin_of(y, z); }
  float *row(std::int64_t y, std::int64_t z) { return values.data() + begin_of(y, z); }

  std::int64_t begin_of(std::int64_t y, std::int64_t z) const
  {
    return (z * size[1] + y) * (size[0] + 2 * kPadding) + kPadding;
  }

  Index3 size;
  std::vector<float> values;
};

/// What a surface goes around: one intensity, or a layer next to the surface and another one beyond that.
enum class Inside { uniform, layered };

/// Takes 12 bytes per sample.
struct ScanModel {
  /// Without a surface yet. Of a volume that may be oversampled the scan's own samples are taken.
  ScanModel(const Window &window, const Volume &volume, Inside inside);

  void set_surface(const Mesh &mesh);

  Window window;
  Inside inside;
  PaddedRows samples;
  PaddedRows shares; ///< 0 .. 1: the part of a voxel that is inside (voxel_shares.h)

  /// The least part inside of a voxel and the 18 that share a face or an edge with it: 0 up to half a voxel inside, 1
  /// from a voxel further on. 0 everywhere where the inside is uniform.
  PaddedRows beyond_shares;
};

} // namespace volsurf
