// What a run found and made.
#pragma once

#include "volsurf/core/timer.h"
#include "volsurf/io/read_volume.h"
#include "volsurf/pipeline/decide_delta.h"
#include "volsurf/surface/check.h"

#include <string>
#include <vector>

namespace volsurf {

/// One of the strongest regions.
struct RegionSummary {
  RegionId id;
  double persistence; ///< infinite for the one that no delta joins
  std::int64_t cells;
  Vec3 maximum_mm; ///< centre of the cell where its field is largest
};

struct Report {
  Settings settings;
  bool is_stored_merge = false; ///< the input is a file of --save-hierarchy
  SourceFile source;            ///< the scan
  std::string pixel_type;
  Grid grid;
  double sigma_mm = 0;
  std::int64_t non_finite_gradients = 0;

  DeltaDecision decision;

  std::int64_t basins = 0;
  double largest_persistence = 0; ///< the largest finite one
  std::int64_t regions = 0;
  RegionId background_region = 0;
  std::vector<RegionSummary> strongest_regions; ///< at most 20, by decreasing persistence

  std::int64_t boundary_faces = 0;
  std::int64_t components = 0;
  std::int64_t components_kept = 0;
  std::vector<double> component_sizes; ///< of those kept, at most 20, by what they were ranked by

  SmoothingResult smoothing;
  MeshCheck mesh;
  std::vector<std::string> warnings;
  int threads = 0;
  StageSeconds seconds;
  std::int64_t peak_memory_bytes = 0;
};

/// As JSON, two spaces deep; docs/report.schema.json describes it.
std::string to_json(const Report &report);

} // namespace volsurf
