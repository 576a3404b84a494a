#include "messages.h"

#include "volsurf/core/error.h"

#include <algorithm>
#include <iostream>

namespace volsurf {

std::string one_line(std::string text)
{
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

void print(const std::string &text)
{
  std::cout << text << std::flush;
  if (!std::cout)
    throw OutputError("standard output: cannot be written to (closed, or on a full disk)");
}

} // namespace volsurf
