#include "volsurf/views/numbers.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace volsurf::views {

namespace {

/// Decimals after the point that leave `digits` significant ones.
int decimals_for(double value, int digits)
{
  return value == 0 ? 0 : digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
}

std::string text_of(double rounded, int decimals)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(std::max(decimals, 0)) << rounded;
  std::string text = out.str();
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
      text.pop_back();
  }
  return text;
}

template <typename Round> double rounded(double value, int decimals, Round round)
{
  // Dividing by a power of ten gives the float nearest to the decimal number, multiplying by a fraction does not.
  const double unit = std::pow(10.0, std::abs(decimals));
  return decimals >= 0 ? round(value * unit) / unit : round(value / unit) * unit;
}

} // namespace

std::string significant(double value, int digits)
{
  if (std::isinf(value))
    return "any";
  const int decimals = decimals_for(value, digits);
  return text_of(rounded(value, decimals, [](double x) { return std::round(x); }), decimals);
}

std::string significant_below(double value, int digits)
{
  if (std::isinf(value))
    return "any";
  const int decimals = decimals_for(value, digits);
  return text_of(rounded(value, decimals, [](double x) { return std::floor(x); }), decimals);
}

std::string grouped(std::int64_t value)
{
  const std::string digits = std::to_string(value);
  std::string result;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0 && digits[i - 1] != '-')
      result += "\u202F";
    result += digits[i];
  }
  return result;
}

} // namespace volsurf::views
