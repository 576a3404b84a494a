// The names of a run's files.
#pragma once

#include "volsurf/pipeline/settings.h"

#include <filesystem>
#include <vector>

namespace volsurf {

/// True for the outputs that hold volumes, which no split divides.
bool is_vdb(const std::filesystem::path &output);

/// True for labels that are to be a segmentation of 3D Slicer: .seg.nrrd.
bool is_segmentation(const std::filesystem::path &labels);

/// The outputs that hold surfaces, in their order.
std::vector<std::filesystem::path> surface_outputs(const Settings &settings);

/// The file of one part of an output: head.stl becomes head_region_07.stl or head_component_07.stl, numbers having as
/// many digits as `highest`, so that they sort. Without a split the output itself.
std::filesystem::path part_file(const std::filesystem::path &output, Split split, std::uint32_t number,
                                std::uint32_t highest);

/// Throws UsageError where two of `outputs` and the settings' input and other outputs are the same file, whatever the
/// spelling and the links.
void require_distinct_files(const Settings &settings, std::vector<std::filesystem::path> outputs);

/// The same for any files.
void require_distinct_files(std::vector<std::filesystem::path> files);

} // namespace volsurf
