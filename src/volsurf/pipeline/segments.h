// The segments of a .seg.nrrd: the regions that were asked for, under names for the user.
#pragma once

#include "volsurf/io/write_segmentation.h"
#include "volsurf/pipeline/selection.h"

namespace volsurf {

/// More are of no use in 3D Slicer's list; the largest regions come first.
constexpr std::size_t kMostSegments = 255;

/// One per region of the selection, the kMostSegments largest: "region 3 (12.4 ml)".
std::vector<Segment> make_segments(const Selection &selection, const Regions &regions, const Grid &grid);

/// Sets the labels that no segment has to 0.
void keep_segments(const std::vector<Segment> &segments, LabelVolume &labels);

} // namespace volsurf
