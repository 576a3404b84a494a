// Smoothing of the staircase of faces, by vtkWindowedSincPolyDataFilter.
//
// Source: Taubin, Zhang, Golub, "Optimal surface smoothing as filter design", ECCV 1996.
#pragma once

#include "volsurf/core/grid.h"
#include "volsurf/core/mesh.h"

#include <optional>

namespace volsurf {

struct SmoothingOptions {
  double strength = 0.5;           ///< 0 .. 1; 0 leaves the faces as they are
  std::optional<int> iterations;   ///< not set: 20 + 20 * strength
  std::optional<double> pass_band; ///< not set: 10^(-1 - 0.7 * strength)
};
// Measured on balls of 4, 8 and 16 voxels: pass bands from 0.1 to 0.03 leave 0.06 to 0.1 voxel of the staircase's 0.45
// and keep the volume within 2 %; at 0.01, which 3D Slicer uses in the middle of its range, the smallest one lost 43 %.

/// Below these the filter was measured to shrink, or to overflow.
constexpr int kFewestIterations = 15;
constexpr double kSmallestPassBand = 1e-3;

/// What the filter did.
struct SmoothingResult {
  int iterations = 0; ///< 0: not smoothed
  double pass_band = 0;
  double volume_drift = 0; ///< relative change of the enclosed volume
};

/// Loss of volume above which a result deserves a warning. A gain does not: placement gives back what staircases lack.
constexpr double kLargestShrinkage = 0.05;

/// Of a surface of that strength where nothing else is asked for.
int usual_iterations(double strength);

/// Throws UsageError for options out of range.
void check_smoothing(const SmoothingOptions &options);

/// Moves the points of `mesh`. Points where three or four faces meet at an edge move along that curve only, its ends
/// stay; points of caps stay in the border planes of `grid`, where the mesh tells its caps. Throws UsageError for
/// options out of range, Error where the filter gives points that are not finite. O(iterations * points).
SmoothingResult smooth_mesh(Mesh &mesh, const Grid &grid, const SmoothingOptions &options);

} // namespace volsurf
