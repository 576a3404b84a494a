// Segmentations of 3D Slicer: label volumes whose header says what each label is.
//
// Source: Slicer's developer guide, "Segmentation labelmap file format (.seg.nrrd)", and its reader,
// vtkMRMLSegmentationStorageNode.
#pragma once

#include "volsurf/core/provenance.h"
#include "volsurf/core/volume.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace volsurf {

/// What Slicer calls a segment: the voxels with one label.
struct Segment {
  std::uint32_t label; ///< > 0
  std::string name;    ///< for the user
};

/// The colour of a label, red, green and blue in 0 .. 1: always the same one, unlike those of the labels close to it.
std::array<double, 3> label_colour(std::uint32_t label);

/// Writes a .seg.nrrd as Slicer 5 does: all segments in one layer, with the tag that says "tissue". `labels` holds the
/// segments' labels and 0. Slicer takes the grid for the segmentation's own, whatever the scan's is. The rest is as in
/// write_labels. Throws OutputError.
void write_segmentation(const LabelVolume &labels, const std::vector<Segment> &segments,
                        const std::filesystem::path &file, const Provenance &provenance);

} // namespace volsurf
