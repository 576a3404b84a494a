// Where the volume, interpolated between its samples, crosses a value.
#pragma once

#include "volsurf/core/volume.h"

#include <vector>

namespace volsurf {

/// Whether the value at a fractional index is at least `iso`, linear along each axis. Nothing beyond the samples is.
bool reaches(const Volume &volume, double iso, const Vec3 &index);

/// A point on the surface where the volume is `iso`, as a fractional index, for each block of `block`^3 samples through
/// which it goes: the first crossing on an edge of the grid, in the order of the samples. O(samples).
std::vector<Vec3> level_crossings(const Volume &volume, double iso, std::int64_t block);

} // namespace volsurf
