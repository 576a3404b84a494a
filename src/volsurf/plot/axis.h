// An axis of a chart: what it shows, and where its ticks are.
#pragma once

#include <string>
#include <vector>

namespace volsurf::plot {

enum class Scale { linear, logarithmic };

/// low < high; with a logarithmic scale low > 0.
struct Axis {
  std::string label; ///< with the unit
  Scale scale = Scale::linear;
  double low = 0;
  double high = 1;
};

struct Tick {
  double value;
  std::string label; ///< empty for one that has no room or need for a number
};

/// Where a value lies: 0 at low, 1 at high, beyond them outside.
double position(const Axis &axis, double value);

/// Ticks within the axis, ascending, of which about `most_labels` at most have labels: round numbers; with a
/// logarithmic scale powers of ten and, where these are few, 2 and 5 times those.
std::vector<Tick> ticks(const Axis &axis, int most_labels);

/// A number as on an axis: 0.02, 5, 300, 20,000, 10 M.
std::string tick_label(double value);

} // namespace volsurf::plot
