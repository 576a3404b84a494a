// The command line of volsurf.
#pragma once

#include "volsurf/pipeline/settings.h"

#include <optional>
#include <string>

namespace volsurf {

enum class Verbosity { quiet, normal, verbose };

struct CommandLine {
  Settings settings;
  bool report_to_stdout = false;
  Verbosity verbosity = Verbosity::normal;
};

/// Something to print and the code to exit with, for --help, --version and errors of usage.
struct EarlyExit {
  int code;
  std::string text;
};

/// Reads the arguments and the file that --config names. Throws UsageError where a value is out of range.
struct ParsedCommandLine {
  CommandLine command_line;
  std::optional<EarlyExit> early_exit;
};
ParsedCommandLine parse_command_line(int argc, const char *const *argv);

} // namespace volsurf
