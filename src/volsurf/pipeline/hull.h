// What a hull leaves outside.
//
// A furrow whose mouth is narrower than the gradient can see has a wall there: it is a region of its own, at any delta
// that does not join it with what it is a furrow of. It is outside all the same. What tells it from a dark body on the
// background is that it is as dark as the background, beside what it lies in.
#pragma once

#include "volsurf/core/cell_labels.h"
#include "volsurf/core/volume.h"
#include "volsurf/topology/hierarchy.h"

namespace volsurf {

/// Per region id, 1 for what is outside of the hull: the background, and the regions that look like it and hang
/// together with it over faces of cells, by themselves or through others of their kind. A region looks like the
/// background where its mean intensity differs from that of the background by less than half of what those around it
/// differ, in the mean over the faces that it shares with them. O(cells).
std::vector<char> find_outside_of_hull(const CellLabels &cells, const Volume &volume, const Regions &regions,
                                       RegionId background);

} // namespace volsurf
