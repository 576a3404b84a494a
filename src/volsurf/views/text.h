// An exploration as text.
#pragma once

#include "volsurf/pipeline/explore.h"

namespace volsurf::views {

/// For a terminal: regions, components and area over delta, the strongest regions, and what to type next.
std::string to_text(const Exploration &exploration);

/// For other programs: delta,regions,components,faces,area_mm2. Each row holds from its delta down to that of the next
/// row, where the next region appears; above the first row's there is no boundary. Rows are there for the 1,000 largest
/// persistences; below them a row whose delta is within 0.1 % of the one before is left out, so that noise gives 2,300
/// rows for each power of ten instead of millions.
std::string to_csv(const BoundaryCurve &curve);

} // namespace volsurf::views
