#include "volsurf/pipeline/decide_delta.h"

#include "volsurf/core/error.h"

namespace volsurf {

namespace {

constexpr std::size_t kMostCandidates = 5;

/// Where delta is in its gap. In the middle hulls of the study's cortex are up to a third further off; above it a
/// region at a seed is, the white matter of ch2bet by half.
constexpr double kPlaceForRegions = 0.5;
constexpr double kPlaceForHull = 0.85;

} // namespace

DeltaAdvice advise_on_delta(const MergedVolume &merged, const EdgeField &field, SurfaceKind surface)
{
  DeltaAdvice advice;
  advice.noise = measure_noise(merged.input.volume, field);
  advice.noise_floor = kNoiseFloor * advice.noise.gradient;
  advice.place_in_gap = surface == SurfaceKind::hull ? kPlaceForHull : kPlaceForRegions;
  advice.candidates =
      find_delta_candidates(merged.merge.hierarchy, advice.noise.gradient, kMostCandidates, advice.place_in_gap);
  return advice;
}

DeltaDecision decide_delta(const Settings &settings, const MergedVolume &merged, const EdgeField &field)
{
  DeltaDecision decision;
  if (std::holds_alternative<AutomaticDelta>(settings.delta))
    decision.advice = advise_on_delta(merged, field, settings.surface);
  decision.delta = resolve_delta(settings.delta, merged.merge.hierarchy,
                                 decision.advice ? decision.advice->candidates : std::vector<DeltaCandidate>{});
  if (!(decision.delta > 0))
    throw EmptyResult(settings.input.string() + ": found no wall that stands out: the largest persistence is " +
                      std::to_string(merged.merge.hierarchy.largest_persistence()) +
                      "; allowed are scans with contrast");
  return decision;
}

} // namespace volsurf
