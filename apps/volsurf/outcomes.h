// What both commands of volsurf say of themselves.
#pragma once

#include "program/program.h"

#include <string>

namespace volsurf {

enum class Verbosity { quiet, normal, verbose };

/// Something to print and the code to exit with, for --help, --version and errors of usage.
struct EarlyExit {
  ExitCode code;
  std::string text;
};

} // namespace volsurf
