// volsurf explore.
#pragma once

#include "explore_command_line.h"

namespace volsurf {

/// Returns the exit code. Throws the errors of core/error.h; Cancelled once a signal was noted.
int run_explore_command(const ExploreCommandLine &line);

} // namespace volsurf
