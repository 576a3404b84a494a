// What of the stages' results goes into the report.
#pragma once

#include "volsurf/pipeline/finishing.h"
#include "volsurf/pipeline/report.h"
#include "volsurf/surface/components.h"
#include "volsurf/topology/region_merge.h"

namespace volsurf {

void summarise_regions(const RegionMerge &merge, const Regions &regions, Report &report);

/// Adds the components of one boundary to those of others.
void add_components(const Components &components, Report &report);

/// Adds what was done to one surface.
void add_finishing(const Finishing &finishing, Report &report);

/// From the surfaces, when all are there: the mesh of all together and how smoothing changed its volume.
void summarise_surfaces(Report &report);

/// Adds what the user should know of a report that is complete otherwise.
void collect_warnings(Report &report);

} // namespace volsurf
