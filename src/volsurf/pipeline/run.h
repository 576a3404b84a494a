// The whole job.
#pragma once

#include "volsurf/core/progress.h"
#include "volsurf/pipeline/report.h"

#include <functional>

namespace volsurf {

/// Reads the input, extracts its surfaces and writes the outputs: all of them or, where anything fails, none. Throws
/// the errors of core/error.h.
///
/// `publish` gets the report when all files are complete and none has appeared yet; where it throws, none will. `found`
/// gets the input's grid as soon as it is known, before the work starts; std::cout and std::cerr are silent then,
/// because ITK is kept from printing.
Report run(const Settings &settings, const Progress &progress = {},
           const std::function<void(const Report &)> &publish = {},
           const std::function<void(const Grid &)> &found = {});

} // namespace volsurf
