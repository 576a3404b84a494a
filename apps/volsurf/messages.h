// What the program prints.
#pragma once

#include <string>

namespace volsurf {

/// File names may hold line breaks, a message has none.
std::string one_line(std::string text);

/// To standard output. Throws OutputError.
void print(const std::string &text);

} // namespace volsurf
