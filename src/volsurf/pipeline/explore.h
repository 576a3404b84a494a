// What every delta would give, so that a user can choose one.
#pragma once

#include "volsurf/core/timer.h"
#include "volsurf/pipeline/decide_delta.h"
#include "volsurf/surface/boundary_curve.h"

#include <optional>
#include <string>
#include <vector>

namespace volsurf {

/// A region that a user may want alone.
struct NotableRegion {
  double persistence; ///< the largest delta at which it is a region of its own; infinite for the last one
  double volume_mm3;  ///< at that delta
  Vec3 point_mm;      ///< in it at each of its deltas, in the frame of the settings: the centre of a cell
  bool is_background; ///< at that delta

  /// Persistence times the radius of a ball of that volume, as an intensity: large for strong walls around much.
  double prominence() const;
};

struct Exploration {
  Settings settings; ///< delta, selection, smoothing and outputs have no meaning here
  SourceFile source;
  std::string pixel_type;
  Grid grid;
  double sigma_mm = 0;
  std::int64_t non_finite_gradients = 0;

  BoundaryCurve curve;
  std::vector<double> volumes_mm3;      ///< per rank, of the basin's region at the delta of its persistence
  std::vector<NotableRegion> strongest; ///< at most 10, by decreasing persistence
  std::vector<NotableRegion> prominent; ///< at most 15 above the noise floor, by decreasing prominence; never the
                                        ///< background
  DeltaAdvice advice;                   ///< the noise floor, and the deltas that suggest themselves

  std::vector<std::string> warnings;
  int threads = 0;
  StageSeconds seconds;
  std::int64_t peak_memory_bytes = 0;

  std::int64_t basins() const { return static_cast<std::int64_t>(curve.persistence.size()); }
  double largest_persistence() const { return curve.persistence[1]; }

  /// The persistence that noise alone may make, where there is noise.
  std::optional<double> noise_floor() const;

  /// What --delta auto takes.
  std::optional<double> automatic_delta() const;
};

/// The curves of a merge's boundary over delta.
BoundaryCurve boundary_curve(const RegionMerge &merge, const Grid &grid, const Progress &progress = {});

/// Reads the input of `settings` and merges it, once. Takes from settings what decides on the hierarchy: input, series,
/// field, exterior; and frame, threads, memory. Throws the errors of core/error.h; EmptyResult where there is no
/// positive persistence, so that every delta gives one region.
Exploration explore(const Settings &settings, const Progress &progress = {},
                    const std::function<void(const Grid &)> &found = {});

} // namespace volsurf
