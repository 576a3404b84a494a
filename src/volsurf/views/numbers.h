// Numbers as people read them.
#pragma once

#include <cstdint>
#include <string>

namespace volsurf::views {

/// With at most so many significant digits, no exponent, no trailing zeros: 14.16, 0.02, 251000. "any" for infinity.
std::string significant(double value, int digits);

/// The same, but never more than the value, so that a delta read off a table still keeps its region. value > 0.
std::string significant_below(double value, int digits);

/// Digits in groups of three, separated by a thin space that does not break: for pages.
std::string grouped(std::int64_t value);

} // namespace volsurf::views
