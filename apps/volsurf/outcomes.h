// What both commands of volsurf say of themselves.
#pragma once

#include <string>

namespace volsurf {

enum class Verbosity { quiet, normal, verbose };

/// Something to print and the code to exit with, for --help, --version and errors of usage.
struct EarlyExit {
  int code;
  std::string text;
};

} // namespace volsurf
