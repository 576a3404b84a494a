// volsurf from the gradient to the components, as its pipeline runs them.
#pragma once

#include "benchmark/measured_run.h"

#include "volsurf/field/gradient.h"
#include "volsurf/surface/boundary.h"
#include "volsurf/topology/region_merge.h"

namespace volsurf::bench {

FieldOptions field_options(const RunOptions &options);

/// Every region but the one with the most border faces, which is the background.
Sides sides_of(const RegionMerge &merge, const Regions &regions);

/// Gradient and merge, cut, boundary, components; `with_mesh`: and the triangles, unsmoothed.
Outcome run_volsurf(const Volume &volume, const RunOptions &options, bool with_mesh);

/// Throws where volsurf finds another number of regions, or other regions if the outcome holds them.
void require_volsurfs_regions(const Outcome &outcome, const Volume &volume, const RunOptions &options);

} // namespace volsurf::bench
