// An exploration as a page: one HTML file that needs nothing else.
#pragma once

#include "volsurf/pipeline/explore.h"

namespace volsurf::views {

std::string to_html(const Exploration &exploration);

} // namespace volsurf::views
