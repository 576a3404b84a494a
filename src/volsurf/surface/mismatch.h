// How far a wall is from where it should be, by what the samples next to it have more or less than it says.
#pragma once

#include "volsurf/surface/scan_model.h"
#include "volsurf/surface/wall_contrast.h"

#include <limits>
#include <optional>

namespace volsurf {

/// How far out the wall at a place should be, and the sd of that, both in voxels.
struct Mismatch {
  double way = 0;   ///< at most 1
  double error = 0; ///< at most 3
};

/// How far a sample may be from what the surface says of it.
struct Doubt {
  double noise = 0;                                       ///< sd
  double limit = std::numeric_limits<double>::infinity(); ///< what is further off counts as being so far off
};

/// From the samples next to a place on the surface. Nothing where there is none. O(1).
std::optional<Mismatch> mismatch_at(const Vec3 &place, const Contrast &contrast, const Doubt &doubt,
                                    const ScanModel &model);

} // namespace volsurf
