// The field I = -|grad g| of a volume, plane by plane.
#pragma once

#include "volsurf/core/plane_source.h"
#include "volsurf/core/volume.h"

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

namespace volsurf {

struct FieldOptions {
  std::optional<double> sigma_mm; ///< sd of the Gaussian; 0: central differences; not set: the mean spacing, on a finer
                                  ///< grid 0.65 of the scan's
  bool edge_map = false;          ///< the volume is an edge strength already: I = -g
};

/// The longest Gaussian in voxels along any axis.
constexpr double kLargestSigmaVoxels = 64;

/// Samples weights[k] of a kernel at distances 0 .. radius from its centre.
using HalfKernel = std::vector<float>;

/// Gaussian of the given sd in voxels, cut at 4 sd, whose weights over -radius .. radius sum to 1.
HalfKernel gaussian_kernel(double sigma_voxels);

/// Its derivative per voxel, scaled so that a linear ramp gets its exact slope. Antisymmetric: the weight at +k is
/// weights[k], at -k its negative.
HalfKernel gaussian_derivative_kernel(double sigma_voxels);

/// Gradients are per millimetre, in float32, in one fixed order of operations:
///
/// - sigma 0, as numpy.gradient: (g[i+1] - g[i-1]) * (1 / 2h), at the border (g[i+1] - g[i]) * (1 / h);
/// - sigma > 0: z, then y, then x; each sum goes outwards from the centre, w[0] c + w[1] (a[1] + b[1]) + ...;
///   beyond the border the volume continues with its border samples;
/// - |grad g| = sqrt((gx gx + gy gy) + gz gz).
///
/// Where that is not finite, I is the most negative finite float: a wall. I is never -0.
class EdgeField {
public:
  /// Keeps a reference to `volume`. Throws UsageError where sigma is negative, not finite or above the limit.
  EdgeField(const Volume &volume, const FieldOptions &options);

  /// Writes rows of plane z of I. Thread-safe; O(samples of the rows * kernel radius), and as many rows as the kernel
  /// is wide in addition.
  void rows(std::int64_t z, const RowRange &rows, float *out) const;

  /// Writes plane z of I.
  void plane(std::int64_t z, float *out) const { rows(z, {0, volume_.grid.size[1]}, out); }

  /// rows() as a function. Keeps a reference to this field.
  PlaneSource planes() const;

  double sigma_mm() const { return sigma_mm_; }

  /// The standard deviation that white noise of deviation 1 in the scan has in a component of the gradient (the
  /// largest over the axes, away from the border), per mm; 1 for an edge map.
  double noise_gain() const;

  /// Samples without a finite gradient, over all rows that have been computed.
  std::int64_t non_finite_count() const;

private:
  void central_difference_rows(std::int64_t z, const RowRange &rows, float *out) const;
  void gaussian_rows(std::int64_t z, const RowRange &rows, float *out) const;
  std::atomic<std::int32_t> &non_finite_of(std::int64_t y, std::int64_t z) const;

  struct AxisKernels {
    HalfKernel smooth;
    HalfKernel derive;
  };

  const Volume &volume_;
  bool edge_map_;
  double sigma_mm_;
  std::array<AxisKernels, 3> kernels_; // per axis, derivatives in units per mm
  std::unique_ptr<std::atomic<std::int32_t>[]> non_finite_of_row_;
};

/// |grad g| as a volume, for users who want to see it.
Volume gradient_magnitude(const EdgeField &field, const Grid &grid);

} // namespace volsurf
