// What a user may say of delta, and the number that it stands for.
#pragma once

#include "volsurf/topology/automatic_delta.h"

#include <string>
#include <variant>

namespace volsurf {

struct AutomaticDelta {}; ///< the best of find_delta_candidates()
struct DeltaValue {
  double per_mm; ///< > 0 and finite, in intensity per mm
};
struct DeltaPercent {
  double percent; ///< > 0 and <= 100: of the largest finite persistence
};
struct DeltaRegions {
  std::int64_t regions; ///< >= 2: the delta that leaves so many
};
using DeltaChoice = std::variant<AutomaticDelta, DeltaValue, DeltaPercent, DeltaRegions>;

/// "auto", a number as "20", or a percentage as "10%". Throws UsageError.
DeltaChoice parse_delta(const std::string &text);

/// As a command line would give it, with its option: "--delta auto", "--delta 20", "--delta 10%", "--regions 5".
std::string delta_text(const DeltaChoice &choice);

/// The number; 0 where there is no wall at all. Numbers that are computed have as few digits as they need. Where walls
/// are equally strong, so that no delta leaves just N regions, DeltaRegions leaves the next larger number of them.
/// Throws UsageError where there are fewer regions at any delta. Only AutomaticDelta looks at `candidates`.
double resolve_delta(const DeltaChoice &choice, const Hierarchy &hierarchy,
                     const std::vector<DeltaCandidate> &candidates);

} // namespace volsurf
