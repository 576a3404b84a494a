// Progress and cancelling, through one callback.
#pragma once

#include "volsurf/core/error.h"

#include <functional>
#include <string_view>

namespace volsurf {

/// Called with the stage's name and the fraction of it that is done (0 .. 1), possibly from several threads. Returns
/// false to stop the run: the stage then throws Cancelled.
using Progress = std::function<bool(std::string_view stage, double fraction)>;

/// Throws Cancelled where the callback asks to stop. An empty callback never does.
inline void report_progress(const Progress &progress, std::string_view stage, double fraction)
{
  if (progress && !progress(stage, fraction))
    throw Cancelled();
}

} // namespace volsurf
