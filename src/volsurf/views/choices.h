// What of an exploration is shown, and what it suggests: the same for all its forms.
#pragma once

#include "volsurf/pipeline/explore.h"

namespace volsurf::views {

/// The deltas that charts and tables show, low < high. Below, there is little but noise.
struct DeltaRange {
  double low;
  double high;
};
DeltaRange shown_range(const Exploration &exploration);

/// A line of the table over delta.
struct DeltaRow {
  double delta;
  std::int64_t regions;
  std::int64_t components;
  double area_mm2;
  std::string note; ///< what is special about this delta, or empty
};

/// 12 to 24 round deltas within the shown range, ascending, and the noise floor and the
/// automatic choice.
std::vector<DeltaRow> delta_rows(const Exploration &exploration);

/// A command to type next, and why.
struct Suggestion {
  std::string command;
  std::string reason;
};

/// The automatic choice and the next best deltas, then the most prominent regions alone.
std::vector<Suggestion> suggestions(const Exploration &exploration);

/// The scan and what it was explored with, in a line.
std::string headline(const Exploration &exploration);

} // namespace volsurf::views
