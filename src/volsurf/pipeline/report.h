// What a run found and made.
#pragma once

#include "volsurf/core/timer.h"
#include "volsurf/io/read_volume.h"
#include "volsurf/pipeline/decide_delta.h"
#include "volsurf/surface/check.h"
#include "volsurf/surface/snap.h"

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

/// A surface that was written: the whole one or, with a split, a part of it.
struct SurfaceSummary {
  std::uint32_t number; ///< of its region or component; 0 for the whole
  std::vector<std::filesystem::path> files;
  MeshCheck mesh;
  double volume_before_mm3; ///< before smoothing

  /// Relative change of the volume by smoothing; has a meaning where the mesh is watertight.
  double volume_drift() const { return volume_before_mm3 == 0 ? 0 : mesh.volume_mm3 / volume_before_mm3 - 1; }
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
  std::optional<PlacementResult> snap; ///< of all surfaces together
  std::vector<SurfaceSummary> surfaces;
  MeshCheck mesh; ///< of all surfaces together
  std::vector<std::string> warnings;
  int threads = 0;
  StageSeconds seconds;
  std::int64_t peak_memory_bytes = 0;
};

/// As JSON, two spaces deep; docs/report.schema.json describes it.
std::string to_json(const Report &report);

} // namespace volsurf
