// From a volume to its regions, by the method that was asked for.
#pragma once

#include "volsurf/pipeline/merged_volume.h"

namespace volsurf {

/// The settings with the iso-value that Otsu's method finds, where one is needed and none was given. O(samples).
Settings settings_with_iso_value(Settings settings, const Volume &volume);

/// The regions of a method that finds some: by merge_input(), or voxels as cells. Settings hold the iso-value where one
/// is needed. Throws EmptyResult where no sample, or each, is at least the iso-value, UsageError as merge_input(), and
/// Cancelled.
void find_regions(MergedVolume &merged, const Settings &settings, const Progress &progress = {});

} // namespace volsurf
