// What of the stages' results goes into the report.
#pragma once

#include "volsurf/pipeline/report.h"
#include "volsurf/surface/components.h"
#include "volsurf/topology/region_merge.h"

namespace volsurf {

void summarise_regions(const RegionMerge &merge, const Regions &regions, Report &report);
void summarise_components(const Components &components, Report &report);

/// Adds what the user should know of a report that is complete otherwise.
void collect_warnings(Report &report);

} // namespace volsurf
