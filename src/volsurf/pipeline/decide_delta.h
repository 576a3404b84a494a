// From what the user said of delta to the number.
#pragma once

#include "volsurf/field/noise_level.h"
#include "volsurf/pipeline/merged_volume.h"
#include "volsurf/topology/delta_choice.h"

namespace volsurf {

/// What is known of the noise, and the deltas that suggest themselves.
struct DeltaAdvice {
  NoiseLevel noise;
  double noise_floor = 0;                 ///< kNoiseFloor deviations: delta above it shows no noise, however small
  double place_in_gap = 0;                ///< of the candidates' deltas: 0 .. 1, in the logarithm
  std::vector<DeltaCandidate> candidates; ///< at most 5, the best first
};

/// Of a merged volume and its field, for a surface of a kind. In a gap between large regions a hull is given a delta
/// further up than regions are: between it and the background there are fewer specks of noise the larger delta is, and
/// what joins within it does not matter. O(basins log basins).
DeltaAdvice advise_on_delta(const MergedVolume &merged, const EdgeField &field, SurfaceKind surface);

struct DeltaDecision {
  double delta = 0;
  std::optional<DeltaAdvice> advice; ///< set where delta was chosen by it
};

/// Throws EmptyResult where there is no wall at all, and UsageError as resolve_delta() does.
DeltaDecision decide_delta(const Settings &settings, const MergedVolume &merged, const EdgeField &field);

} // namespace volsurf
