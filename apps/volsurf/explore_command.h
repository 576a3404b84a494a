// volsurf explore.
#pragma once

#include "explore_command_line.h"

#include <atomic>

namespace volsurf {

/// Returns the exit code. Throws the errors of core/error.h; Cancelled once `interrupted` is set.
int run_explore_command(const ExploreCommandLine &line, const std::atomic<bool> &interrupted);

} // namespace volsurf
