// Numbers as a command line gives them.
#pragma once

#include <optional>
#include <string>

namespace volsurf {

struct NumberText {
  double number;
  bool is_percentage;
};

/// A number ("3", "0.5", "1e-3") or a percentage ("5%") and nothing else around it; nothing for any other text and
/// beyond the range of double. Neither nan nor inf is refused.
std::optional<NumberText> parse_number_text(const std::string &text);

} // namespace volsurf
