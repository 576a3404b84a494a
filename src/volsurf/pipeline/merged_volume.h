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
  FieldOptions field;                    ///< what the merge is made with, as it was given
  Exterior exterior = Exterior::none;    ///< likewise
  std::int64_t non_finite_gradients = 0; ///< samples that were taken as walls
  RegionMerge merge;                     ///< empty where the volume has been read only

  bool is_merged() const { return merge.hierarchy.basin_count() > 0; }
};

/// The memory that a run on such a grid is expected to take at most, meshes excepted: the samples and the merge.
std::uint64_t expected_memory_bytes(const Grid &grid);

/// Reads settings.input. `found` gets its grid before the samples are read. Throws InputError, also where more memory
/// would be needed than settings allow.
MergedVolume read_input(const Settings &settings, const Progress &progress = {},
                        const std::function<void(const Grid &)> &found = {});

/// Computes the gradient and merges, unless that is done already. Throws UsageError for a sigma out of range, and
/// Cancelled.
void merge_input(MergedVolume &merged, const Progress &progress = {});

} // namespace volsurf
