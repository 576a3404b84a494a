// Everything that is measured between two bodies.
#pragma once

#include "volsurf/compare/overlap.h"
#include "volsurf/compare/surface_distances.h"
#include "volsurf/compare/vertex_distances.h"
#include "volsurf/core/progress.h"
#include "volsurf/pipeline/shape.h"

#include <optional>
#include <string>
#include <vector>

namespace volsurf {

struct ComparisonOptions {
  std::optional<double> tolerance_mm; ///< not set: the smallest spacing of a label volume, or 1 mm without one
  std::int64_t samples = DistanceOptions().samples;
  double spacing_mm = 0; ///< of the grid for the overlap of two surfaces; 0: 1/256 of their longest extent
};

struct Comparison {
  SurfaceDistances distances;
  VertexDistances vertices;       ///< b is the reference
  std::optional<Overlap> overlap; ///< where both are closed
  double tolerance_mm = 0;
  bool a_is_closed = false; ///< so that distances to it have a side
  bool b_is_closed = false;
  std::optional<double> volume_a_mm3;
  std::optional<double> volume_b_mm3;
  std::vector<std::string> warnings; ///< what the user should know, one line each
};

/// Measures a against b, the reference. Throws InputError where a grid for the overlap would be too large, Cancelled.
Comparison compare(const Shape &a, const Shape &b, const ComparisonOptions &options = {},
                   const Progress &progress = {});

} // namespace volsurf
