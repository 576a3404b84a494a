// Whether to look at a scan on a grid twice as fine.
#pragma once

#include "volsurf/core/volume.h"
#include "volsurf/pipeline/settings.h"

namespace volsurf {

/// Scans of more samples, a hundred along each axis, keep their own grid: a finer one has eight times as many.
constexpr std::int64_t kMostSamplesToOversample = 100 * 100 * 100;

/// Whether --oversample is left to the scan's folds: for volsurf's own regions of a small scan, without thick slices,
/// where it is not given, nor --delta, --sigma or --save-hierarchy, whose meaning depends on the grid, and where memory
/// will do.
bool leaves_oversampling_to_scan(const Settings &settings, const Grid &scan);

/// 2 for a scan with folds that its own grid hardly holds, otherwise 1. O(samples).
int choose_oversampling(const Volume &scan);

} // namespace volsurf
