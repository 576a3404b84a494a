// A merged volume in one file, from which every later cut is made without the scan.
//
// The file is an array file (io/array_file.h); docs/hierarchy_format.md tells what is in it.
#pragma once

#include "volsurf/pipeline/merged_volume.h"

namespace volsurf {

/// Throws UsageError unless the extension is .volsurf.
void require_hierarchy_extension(const std::filesystem::path &path);

/// Writes the volume, the merge and how it was made. The same merge makes the same bytes. O(samples). Throws
/// OutputError.
void write_merge(const MergedVolume &merged, const std::filesystem::path &path);

/// True where a file begins as those of write_merge do, whatever its name and version.
bool is_stored_merge(const std::filesystem::path &path);

/// Reads what write_merge wrote, equal in every value. `check_grid` is called before memory is taken; it may throw.
/// Throws InputError for a file that is damaged, incomplete, of another version or contradicts itself. O(samples).
MergedVolume read_merge(const std::filesystem::path &path, const std::function<void(const Grid &)> &check_grid = {});

} // namespace volsurf
