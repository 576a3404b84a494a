// An exploration as charts, which share their axis of delta.
#pragma once

#include "volsurf/pipeline/explore.h"
#include "volsurf/plot/chart.h"

namespace volsurf::views {

plot::Chart regions_chart(const Exploration &exploration); ///< regions and components over delta
plot::Chart area_chart(const Exploration &exploration);    ///< area of the boundary over delta
plot::Chart volumes_chart(const Exploration &exploration); ///< each basin: persistence and the volume of its region

/// All three below each other as a PNG file's bytes.
std::string to_png(const Exploration &exploration);

} // namespace volsurf::views
