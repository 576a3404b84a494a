// How much of their volumes two bodies share.
#pragma once

#include "volsurf/compare/mask.h"

namespace volsurf {

/// Counted in samples of one grid. docs/metrics.md has the formulas.
struct Overlap {
  std::int64_t samples_a = 0;
  std::int64_t samples_b = 0;
  std::int64_t samples_both = 0;
  Vec3 spacing_mm{0, 0, 0};
  double dice = 0;
  double jaccard = 0;
};

/// The largest number of samples that measure_overlap uses.
constexpr std::int64_t kMostOverlapSamples = std::int64_t{1} << 30;

/// Of two masks on the same grid.
Overlap measure_overlap(const Mask &a, const Mask &b);

/// A mask and a closed surface, on the mask's grid, continued as far as the surface reaches. Throws InputError where
/// that is more than kMostOverlapSamples.
Overlap measure_overlap(const Mask &a, const Mesh &b);

/// Two closed surfaces, on a common grid of cubes along the world's axes with this spacing (0: overlap_spacing_mm).
/// Throws InputError where that is more than kMostOverlapSamples.
Overlap measure_overlap(const Mesh &a, const Mesh &b, double spacing_mm = 0);

/// 1/256 of the longest side of the box round both.
double overlap_spacing_mm(const Mesh &a, const Mesh &b);

/// Two masks whose grids share a lattice are put on one grid that holds both; nothing where they do not.
std::optional<Overlap> measure_lattice_overlap(const Mask &a, const Mask &b);

} // namespace volsurf
