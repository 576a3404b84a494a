// The median filter: it takes out impulses (single samples of any value at all), which no gradient can bear, and leaves
// straight edges where they are.
//
// Source: Tukey, "Exploratory Data Analysis", 1977; by itk::MedianImageFilter.
#pragma once

#include "volsurf/core/progress.h"
#include "volsurf/core/volume.h"

namespace volsurf {

/// Larger ones take out more than impulses, and minutes.
constexpr int kLargestMedian = 3;

/// Replaces each sample by the median of the (2 * radius + 1)^3 around it; beyond the border the volume continues with
/// its border samples. Radius 0 does nothing. Takes 4 bytes per sample for the time being; parallel,
/// O(samples * radius^3). Throws UsageError for a radius out of range, and Cancelled.
void filter_by_median(Volume &volume, int radius_voxels, const Progress &progress = {});

} // namespace volsurf
