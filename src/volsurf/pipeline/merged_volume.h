// A volume and the merge of its regions: all that an answer to any delta needs.
#pragma once

#include "volsurf/core/progress.h"
#include "volsurf/io/read_volume.h"
#include "volsurf/pipeline/settings.h"
#include "volsurf/topology/region_merge.h"

#include <functional>

namespace volsurf {

struct MergedVolume {
  InputVolume input;
  bool is_stored = false;                ///< it comes from a file of --save-hierarchy, not from the scan itself
  std::string series_uid;                ///< of the DICOM series that was asked for, if one was
  int median_voxels = 0;                 ///< radius of the filter that the samples have gone through
  FieldOptions field;                    ///< what the merge is made with, as it was given
  Exterior exterior = Exterior::none;    ///< likewise
  std::int64_t non_finite_gradients = 0; ///< samples that were taken as walls
  RegionMerge merge;                     ///< empty where the volume has been read only
  bool cells_are_voxels = false;         ///< those around the samples; else the cubes between them

  bool is_merged() const { return merge.hierarchy.basin_count() > 0; }
};

/// The grid of the cells' corners.
Grid corner_grid(const MergedVolume &merged);

/// The memory that a run on such a grid is expected to take at most, meshes excepted: the samples and the merge.
std::uint64_t expected_memory_bytes(const Grid &grid, Method method = Method::volsurf);

/// A run that would swap or be killed is better refused before it begins: throws InputError where settings do not allow
/// so much.
void require_memory(const Settings &settings, const Grid &grid, std::uint64_t needed_bytes);

/// The name of the scan, without its folder.
std::string source_name(const MergedVolume &merged);

/// Reads settings.input, a scan or a file of --save-hierarchy, which is told by its first bytes, takes the medians of a
/// scan and oversamples it where settings ask for that. `found` gets the grid to come before the samples are read.
/// Throws InputError, also where more memory would be needed than settings allow, and UsageError where settings ask for
/// another median, field, exterior or series than the file holds.
MergedVolume read_input(const Settings &settings, const Progress &progress = {},
                        const std::function<void(const Grid &)> &found = {});

/// Settings with the median, field, exterior and series that the merge is made with.
Settings settings_of_merge(Settings settings, const MergedVolume &merged);

/// Computes the gradient and merges, unless that is done already. Throws UsageError for a sigma out of range, and
/// Cancelled.
void merge_input(MergedVolume &merged, const Progress &progress = {});

} // namespace volsurf
