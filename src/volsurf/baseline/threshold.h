// The plainest segmentation: what is bright enough.
#pragma once

#include "volsurf/core/volume.h"

namespace volsurf {

/// 1 at the samples whose value is at least `iso`, 0 at the others. O(samples), parallel.
LabelVolume threshold(const Volume &volume, double iso);

} // namespace volsurf
