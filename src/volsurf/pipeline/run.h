// The whole job.
#pragma once

#include "volsurf/core/progress.h"
#include "volsurf/pipeline/report.h"

namespace volsurf {

/// Reads the input, extracts its surfaces and writes the outputs: all of them or, where anything fails, none. Throws
/// the errors of core/error.h.
Report run(const Settings &settings, const Progress &progress = {});

} // namespace volsurf
