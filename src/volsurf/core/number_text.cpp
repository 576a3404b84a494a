#include "volsurf/core/number_text.h"

#include <stdexcept>

namespace volsurf {

std::optional<NumberText> parse_number_text(const std::string &text)
{
  try {
    std::size_t used = 0;
    const double number = std::stod(text, &used);
    if (used == text.size())
      return NumberText{number, false};
    if (text.substr(used) == "%")
      return NumberText{number, true};
  } catch (const std::logic_error &) {
    // not a number
  }
  return std::nullopt;
}

} // namespace volsurf
