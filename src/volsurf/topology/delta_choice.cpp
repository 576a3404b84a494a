#include "volsurf/topology/delta_choice.h"

#include "volsurf/core/error.h"
#include "volsurf/core/number_text.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace volsurf {

namespace {

struct ChoiceText {
  std::ostringstream &out;

  void operator()(const AutomaticDelta &) const { out << "--delta auto"; }
  void operator()(const DeltaValue &value) const { out << "--delta " << value.per_mm; }
  void operator()(const DeltaPercent &value) const { out << "--delta " << value.percent << '%'; }
  void operator()(const DeltaRegions &value) const { out << "--regions " << value.regions; }
};

struct Resolver {
  const Hierarchy &hierarchy;
  const std::vector<DeltaCandidate> &candidates;

  double operator()(const AutomaticDelta &) const { return candidates.empty() ? 0 : candidates.front().delta; }
  double operator()(const DeltaValue &value) const { return value.per_mm; }

  double operator()(const DeltaPercent &value) const
  {
    constexpr double kRounding = 5e-4;
    const auto largest = static_cast<double>(hierarchy.largest_persistence());
    const double delta = value.percent / 100 * largest;
    return delta > 0 ? short_number_between(delta * (1 - kRounding), std::min(largest, delta * (1 + kRounding))) : 0;
  }

  double operator()(const DeltaRegions &value) const
  {
    const auto rank_below = static_cast<std::size_t>(value.regions);
    const std::size_t most = hierarchy.region_count(std::numeric_limits<double>::denorm_min());
    if (rank_below > most)
      throw UsageError("--regions: found " + std::to_string(value.regions) + "; allowed are 2 to " +
                       std::to_string(most) + ", as many as the scan has at any delta");
    const auto last_kept = static_cast<double>(hierarchy.persistence[hierarchy.by_rank[rank_below - 1]]);
    const auto first_lost =
        rank_below < most ? static_cast<double>(hierarchy.persistence[hierarchy.by_rank[rank_below]]) : last_kept / 2;
    return first_lost < last_kept ? short_number_between(first_lost, last_kept) : last_kept;
  }
};

} // namespace

DeltaChoice parse_delta(const std::string &text)
{
  if (text == "auto")
    return AutomaticDelta{};
  const auto parsed = parse_number_text(text);
  if (parsed && !parsed->is_percentage && parsed->number > 0 && std::isfinite(parsed->number))
    return DeltaValue{parsed->number};
  if (parsed && parsed->is_percentage && parsed->number > 0 && parsed->number <= 100)
    return DeltaPercent{parsed->number};
  throw UsageError("--delta: found \"" + text +
                   "\"; allowed are finite numbers above 0, in intensity per mm, percentages above 0 and up to 100 of "
                   "the largest persistence (10%), and auto");
}

std::string delta_text(const DeltaChoice &choice)
{
  std::ostringstream out;
  out.precision(9);
  std::visit(ChoiceText{out}, choice);
  return out.str();
}

double resolve_delta(const DeltaChoice &choice, const Hierarchy &hierarchy,
                     const std::vector<DeltaCandidate> &candidates)
{
  return std::visit(Resolver{hierarchy, candidates}, choice);
}

} // namespace volsurf
