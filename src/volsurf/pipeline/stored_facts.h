// What a stored merge tells of itself beside its arrays: the grid, how the merge was made, and of what.
#pragma once

#include "volsurf/pipeline/merged_volume.h"

namespace volsurf {

/// As JSON; docs/hierarchy_format.md describes it.
std::string facts_of(const MergedVolume &merged);

/// A merged volume without its arrays. Throws InputError, naming `path`, where a fact is missing or out of range.
MergedVolume merged_volume_of(const std::string &facts, const std::filesystem::path &path);

} // namespace volsurf
