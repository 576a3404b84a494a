// The measures of a comparison by name, and demands on them.
#pragma once

#include "volsurf/pipeline/comparison.h"

#include <optional>
#include <string>
#include <vector>

namespace volsurf {

struct Metric {
  const char *name;                                             ///< as in `--require dice>=0.95` and in the JSON
  const char *unit;                                             ///< "mm", "mm2", "mm3", "dB", or "" for a ratio
  std::optional<double> (*value)(const Comparison &comparison); ///< nothing where it has no meaning
};

/// All of them, in the order of the JSON. docs/metrics.md defines each.
const std::vector<Metric> &metrics();

enum class Relation { less, at_most, greater, at_least };

/// What `--require` asks for.
struct Requirement {
  std::string text; ///< as it was given
  const Metric *metric = nullptr;
  Relation relation = Relation::at_most;
  double bound = 0;
};

/// From "assd<=0.3", also with <, > and >=, and blanks. Throws UsageError.
Requirement parse_requirement(const std::string &text);

/// False also where the metric has no value.
bool is_met(const Requirement &requirement, const Comparison &comparison);

} // namespace volsurf
