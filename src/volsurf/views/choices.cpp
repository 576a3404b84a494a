#include "volsurf/views/choices.h"

#include "volsurf/views/numbers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

namespace volsurf::views {

namespace {

/// Multiples within a power of ten, from coarse to fine.
const std::vector<std::vector<double>> kSeries{
    {1, 1.5, 2, 3, 5, 7},
    {1, 1.2, 1.5, 1.8, 2.2, 2.7, 3.3, 4, 5, 6, 7, 8},
    {1, 1.1, 1.2, 1.3, 1.5, 1.6, 1.8, 2, 2.2, 2.4, 2.7, 3, 3.3, 3.6, 4, 4.5, 5, 5.5, 6, 6.5, 7, 7.5, 8, 9}};
constexpr std::size_t kFewestRows = 12;

std::set<double> series_between(const std::vector<double> &series, const DeltaRange &range)
{
  std::set<double> deltas;
  for (double power = std::floor(std::log10(range.low)); power <= std::log10(range.high); ++power)
    for (const double factor : series) {
      const double delta = power < 0 ? factor / std::pow(10.0, -power) : factor * std::pow(10.0, power);
      if (delta >= range.low && delta <= range.high)
        deltas.insert(delta);
    }
  return deltas;
}

std::set<double> round_deltas(const DeltaRange &range)
{
  std::set<double> deltas;
  for (const auto &series : kSeries) {
    deltas = series_between(series, range);
    if (deltas.size() >= kFewestRows)
      break;
  }
  return deltas;
}

DeltaRow row_at(const Exploration &exploration, double delta, const std::string &note)
{
  const BoundaryCurve &curve = exploration.curve;
  return {delta, static_cast<std::int64_t>(curve.regions_at(delta)), curve.components_at(delta), curve.area_at(delta),
          note};
}

std::string quoted_for_shell(const std::string &word)
{
  const auto is_plain = [](char c) {
    return (std::isalnum(static_cast<unsigned char>(c)) != 0) || std::string("/._-+=:,@%").find(c) != std::string::npos;
  };
  if (!word.empty() && word[0] != '-' && std::all_of(word.begin(), word.end(), is_plain))
    return word;
  std::string quoted = "'";
  for (const char c : word)
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// The words of a command that decide on the hierarchy, as they were given.
std::string command_start(const Settings &settings)
{
  std::ostringstream out;
  out.precision(9);
  out << "volsurf " << quoted_for_shell(settings.input.string());
  if (!settings.series_uid.empty())
    out << " --series " << quoted_for_shell(settings.series_uid);
  if (settings.median_voxels.value_or(0) > 0)
    out << " --median " << *settings.median_voxels;
  if (settings.oversampling.value_or(1) > 1)
    out << " --oversample " << *settings.oversampling;
  if (settings.field.edge_map)
    out << " --edge-map";
  else if (settings.field.sigma_mm)
    out << " --sigma " << *settings.field.sigma_mm;
  if (settings.exterior == Exterior::infinite)
    out << " --exterior infinite";
  return out.str();
}

/// The best candidate is what --delta auto takes.
Suggestion suggestion_of(const DeltaCandidate &candidate, bool is_best, const Settings &settings)
{
  return {command_start(settings) + " --delta " + (is_best ? "auto" : significant(candidate.delta, 9)),
          (is_best ? "takes delta " + significant(candidate.delta, 9) + ": " : "") + std::to_string(candidate.regions) +
              " regions; large ones hardly change from " + significant(candidate.low, 3) + " to " +
              significant_below(candidate.high, 3)};
}

Suggestion suggestion_of(const NotableRegion &region, const Settings &settings)
{
  std::ostringstream command;
  command.precision(9);
  command << command_start(settings) << " --delta " << significant_below(region.persistence, 4)
          << " --seed=" << region.point_mm[0] << ',' << region.point_mm[1] << ',' << region.point_mm[2];
  if (settings.frame == Frame::ras)
    command << " --frame ras";
  return {command.str(), "a prominent region alone, of " + significant(region.volume_mm3 / 1000, 3) + " ml"};
}

} // namespace

DeltaRange shown_range(const Exploration &exploration)
{
  constexpr double kWidest = 300;
  const auto &persistence = exploration.curve.persistence;
  const double largest = exploration.largest_persistence();
  double low = std::max<double>(largest / kWidest, persistence[persistence.size() * 9 / 10]);
  if (const auto floor = exploration.noise_floor())
    low = std::min(low, *floor / 2);
  return {std::min(low, largest / 4), 1.2 * largest};
}

std::vector<DeltaRow> delta_rows(const Exploration &exploration)
{
  DeltaRange range = shown_range(exploration);
  range.high = exploration.largest_persistence();
  std::map<double, std::string> notes;
  if (const auto floor = exploration.noise_floor())
    notes[*floor] = "the noise floor";
  if (const auto automatic = exploration.automatic_delta())
    notes[*automatic] = "--delta auto";
  for (const double delta : round_deltas(range))
    notes.try_emplace(delta, "");
  std::vector<DeltaRow> rows;
  rows.reserve(notes.size());
  for (const auto &[delta, note] : notes)
    rows.push_back(row_at(exploration, delta, note));
  return rows;
}

std::vector<Suggestion> suggestions(const Exploration &exploration)
{
  constexpr std::size_t kMostCandidates = 3;
  constexpr std::size_t kMostProminent = 3;
  const auto &[settings, candidates, prominent] =
      std::tie(exploration.settings, exploration.advice.candidates, exploration.prominent);
  std::vector<Suggestion> result;
  for (std::size_t i = 0; i < std::min(kMostCandidates, candidates.size()); ++i)
    result.push_back(suggestion_of(candidates[i], i == 0, settings));
  for (std::size_t i = 0; i < std::min(kMostProminent, prominent.size()); ++i)
    result.push_back(suggestion_of(prominent[i], settings));
  return result;
}

std::string headline(const Exploration &exploration)
{
  const Grid &grid = exploration.grid;
  std::ostringstream out;
  out << grid.size[0] << " x " << grid.size[1] << " x " << grid.size[2] << " samples of "
      << significant(grid.spacing_mm[0], 4) << " x " << significant(grid.spacing_mm[1], 4) << " x "
      << significant(grid.spacing_mm[2], 4) << " mm";
  if (exploration.settings.field.edge_map)
    out << ", an edge map";
  else
    out << ", sigma " << significant(exploration.sigma_mm, 4) << " mm";
  out << ", exterior " << (exploration.settings.exterior == Exterior::infinite ? "infinite" : "none");
  return out.str();
}

} // namespace volsurf::views
