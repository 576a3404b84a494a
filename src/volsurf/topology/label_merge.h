// Regions that somebody else found, seen as a merge: basins that no delta joins. So what follows a merge works on them,
// too.
#pragma once

#include "volsurf/core/volume.h"
#include "volsurf/topology/region_merge.h"

namespace volsurf {

/// The voxel around each sample of `labels` becomes a cell (on the grid voxel_corner_grid()), each label a basin whose
/// persistence is infinite; basins are numbered by their first cell. The background is the basin of label 0 or, where
/// that does not occur, the one with the most border faces, ties by number. O(samples).
RegionMerge merge_of_labels(const LabelVolume &labels);

} // namespace volsurf
