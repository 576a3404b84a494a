// A volume on a grid twice as fine, so that what is thinner than two voxels has samples of its own.
//
// Between two walls that are closer than that the gradient turns round from one sample to the next, and |grad g| misses
// its zero in between: furrows and blades close up, whatever delta is. The finer grid has a sample there.
//
// In: a volume of n samples along an axis. Out: 2n - 1 of them, every second one as it was, the others cubic between
// the four around, (-1, 9, 9, -1) / 16; beyond the border the volume continues with its border samples. Passes: along x
// and y within each plane, then the planes between.
//
// Source: Keys, "Cubic convolution interpolation for digital image processing", IEEE Trans. ASSP 29 (1981).
#pragma once

#include "volsurf/core/volume.h"

namespace volsurf {

/// Samples along each axis for one of the scan, at most.
constexpr int kLargestOversampling = 2;

/// The grid of a volume that is `factor` times as fine, its first sample in the same place.
Grid oversampled_grid(const Grid &grid, int factor);

/// The scan's own grid, which that one was made from.
Grid scan_grid(const Grid &fine);

/// Replaces the volume, which must be the scan's own; 1 leaves it as it is. Throws UsageError for other factors than 1
/// and 2. O(samples), parallel; takes 8 times the memory of the volume beside it.
void oversample(Volume &volume, int factor);

} // namespace volsurf
