// Distances between two surfaces, as integrals over their areas.
#pragma once

#include "volsurf/compare/nearest_surface.h"

#include <cstdint>
#include <vector>

namespace volsurf {

struct DistanceOptions {
  double tolerance_mm = 1;       ///< of the area that counts as agreeing, 0 or more
  std::int64_t samples = 400000; ///< per surface, besides one in every triangle
};

/// From one surface to another. docs/metrics.md has the formulas.
struct DirectedDistances {
  double area_mm2 = 0; ///< of the surface that the distances start from
  double mean_mm = 0;
  double rms_mm = 0;
  double percentile95_mm = 0;         ///< the smallest distance that 95 % of the area do not exceed
  double maximum_mm = 0;              ///< over the samples and the vertices
  double signed_mean_mm = 0;          ///< positive outside of the other surface
  double area_within = 0;             ///< the part of the area at most the tolerance away, 0 .. 1
  std::vector<double> at_vertices_mm; ///< signed, for each vertex of the surface that the distances start from
};

struct SurfaceDistances {
  DirectedDistances a_to_b;
  DirectedDistances b_to_a;
  double assd_mm = 0;      ///< mean over both areas
  double rms_mm = 0;       ///< root of the mean square over both areas
  double hd95_mm = 0;      ///< the larger of the two percentiles
  double hausdorff_mm = 0; ///< the larger of the two maxima
  double bias_mm = 0;      ///< mean signed distance over both areas; positive where a lies outside of b
  double surface_dice = 0; ///< the part of both areas at most the tolerance away from the other surface
};

/// Distances from `from`, every triangle of which must have an area, to `to`.
DirectedDistances directed_distances(const Mesh &from, const NearestSurface &to, const DistanceOptions &options);

SurfaceDistances combine(DirectedDistances a_to_b, DirectedDistances b_to_a);

/// Both directions. The signed distances have a meaning where both surfaces are closed with normals outwards.
/// O((triangles + samples) log triangles) on all threads; the same result for any number of them.
SurfaceDistances measure_distances(const Mesh &a, const Mesh &b, const DistanceOptions &options = {});

} // namespace volsurf
