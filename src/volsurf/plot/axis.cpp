#include "volsurf/plot/axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace volsurf::plot {

namespace {

/// A little room, so that a tick at the very end is not lost to rounding.
constexpr double kTolerance = 1e-9;

bool is_within(const Axis &axis, double value)
{
  const double at = position(axis, value);
  return at >= -kTolerance && at <= 1 + kTolerance;
}

/// 1, 2 or 5 times a power of ten, at least `step`.
double round_step(double step)
{
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= step * (1 - kTolerance))
      return factor * power;
  return 10 * power;
}

std::vector<Tick> linear_ticks(const Axis &axis, int most_labels)
{
  const double step = round_step((axis.high - axis.low) / most_labels);
  std::vector<Tick> result;
  for (double i = std::ceil(axis.low / step - kTolerance); is_within(axis, i * step); ++i)
    result.push_back({i * step + 0.0, tick_label(i * step + 0.0)}); // no -0
  return result;
}

/// Multiples of powers of ten within the axis, ascending; of the powers themselves only every so many.
std::vector<double> multiples(const Axis &axis, const std::vector<int> &factors, int every)
{
  std::vector<double> values;
  for (int power = static_cast<int>(std::floor(std::log10(axis.low))); power <= std::log10(axis.high) + 1; ++power)
    for (const int factor : factors) {
      // Below one, the quotient is the float nearest to the decimal number.
      const double value = power < 0 ? factor / std::pow(10.0, -power) : factor * std::pow(10.0, power);
      if (power % every == 0 && is_within(axis, value))
        values.push_back(value);
    }
  return values;
}

std::vector<double> labelled_multiples(const Axis &axis, int most_labels)
{
  for (const auto &factors : {std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9}, std::vector<int>{1, 2, 5}}) {
    auto values = multiples(axis, factors, 1);
    if (values.size() <= static_cast<std::size_t>(most_labels))
      return values;
  }
  const double decades = std::log10(axis.high / axis.low);
  return multiples(axis, {1}, std::max(1, static_cast<int>(std::ceil(decades / most_labels))));
}

std::vector<Tick> logarithmic_ticks(const Axis &axis, int most_labels)
{
  const auto labelled = labelled_multiples(axis, most_labels);
  std::vector<Tick> result;
  for (const double value : multiples(axis, {1, 2, 3, 4, 5, 6, 7, 8, 9}, 1)) {
    const bool has_label = std::binary_search(labelled.begin(), labelled.end(), value);
    result.push_back({value, has_label ? tick_label(value) : ""});
  }
  return result;
}

std::string with_commas(const std::string &digits)
{
  std::string result;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0 && digits[i - 1] != '-')
      result += ',';
    result += digits[i];
  }
  return result;
}

} // namespace

double position(const Axis &axis, double value)
{
  if (axis.scale == Scale::logarithmic)
    return std::log(value / axis.low) / std::log(axis.high / axis.low);
  return (value - axis.low) / (axis.high - axis.low);
}

std::vector<Tick> ticks(const Axis &axis, int most_labels)
{
  return axis.scale == Scale::logarithmic ? logarithmic_ticks(axis, most_labels) : linear_ticks(axis, most_labels);
}

std::string tick_label(double value)
{
  char text[40];
  const double size = std::abs(value);
  if (size >= 1e6 || (size > 0 && size < 1e-4)) {
    const bool millions = size >= 1e6 && size < 1e9;
    std::snprintf(text, sizeof text, millions ? "%.6g M" : "%.3g", millions ? value / 1e6 : value);
    return text;
  }
  if (size >= 1000) {
    std::snprintf(text, sizeof text, "%.0f", value);
    return with_commas(text);
  }
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

} // namespace volsurf::plot
