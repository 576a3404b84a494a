// The command line of volsurf.
#pragma once

#include "outcomes.h"

#include "volsurf/pipeline/settings.h"

#include <optional>
#include <string>

namespace volsurf {

struct CommandLine {
  Settings settings;
  bool report_to_stdout = false;
  Verbosity verbosity = Verbosity::normal;
};

/// Reads the arguments and the file that --config names. Throws UsageError where a value is out of range.
struct ParsedCommandLine {
  CommandLine command_line;
  std::optional<EarlyExit> early_exit;
};
ParsedCommandLine parse_command_line(int argc, const char *const *argv);

} // namespace volsurf
