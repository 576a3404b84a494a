// What a hull leaves outside.
//
// A furrow whose mouth is narrower than the gradient can see has a wall there: it is a region of its own, at any delta
// that does not join it with what it is a furrow of. It is outside all the same. What tells it from a dark body on the
// background is that it is as dark as the background, beside what it lies in; and from a cavity that it opens to the
// background.
#pragma once

#include "volsurf/core/cell_labels.h"
#include "volsurf/core/volume.h"
#include "volsurf/topology/hierarchy.h"

namespace volsurf {

/// Per region id, 1 for what is outside of the hull: the background, and its furrows. These are the regions that share
/// at least 5 % of their faces with the background, and whose mean intensity differs from that of the background by
/// less than half of what those around them differ, in the mean over the faces that they share. O(cells).
std::vector<char> find_outside_of_hull(const CellLabels &cells, const Volume &volume, const Regions &regions,
                                       RegionId background);

} // namespace volsurf
