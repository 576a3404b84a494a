#include "volsurf/topology/automatic_delta.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace volsurf {

namespace {

/// What counts as large, as multiples of a part of the scan that is first 1 %.
constexpr std::array<double, 5> kPartFactors{0.5, 0.7, 1.0, 1.4, 2.0};
constexpr double kFirstPart = 0.01;
constexpr double kNextPart = 0.1; ///< times as large, where no region of the last size stands out

/// Noise merges its regions of 1 % of the scan below this many deviations of the gradient, its smallest ones below
/// kNoiseFloor.
constexpr double kNoiseMerges = 0.7;

/// A wall of a large region stands out where it is so many times as strong as those of noise, and not by chance.
constexpr double kStandsOut = 1.25;

/// The search ends this far below the strongest wall: so weak a wall beside it is texture.
constexpr double kLargestRatio = 16;

/// By how much a candidate may leave its place in the gap for the sake of few digits.
constexpr double kRounding = 1.05;

/// The largest persistence of the merges of at least `cells`; 0 where there is none.
double strongest_of(const std::vector<Merge> &merges, double cells)
{
  const auto large = [&](const Merge &merge) { return static_cast<double>(merge.cells) >= cells; };
  const auto strongest = std::find_if(merges.begin(), merges.end(), large);
  return strongest == merges.end() ? 0 : strongest->persistence;
}

/// The persistences of the merges of at least `cells`, decreasing, down to `lowest`, which ends the list.
std::vector<double> walls_of(const std::vector<Merge> &merges, double cells, double lowest)
{
  std::vector<double> walls;
  for (const Merge &merge : merges)
    if (static_cast<double>(merge.cells) >= cells && merge.persistence > lowest)
      walls.push_back(merge.persistence);
  walls.push_back(lowest);
  return walls;
}

/// The gaps between all walls, each with its width, from the strongest wall of a region of `part` down to `lowest`.
std::vector<DeltaCandidate> measure_gaps(const std::vector<Merge> &merges, double all_cells, double part,
                                         double strongest, double lowest)
{
  std::array<std::vector<double>, kPartFactors.size()> walls;
  std::vector<double> ends{lowest};
  for (std::size_t i = 0; i < kPartFactors.size(); ++i) {
    walls[i] = walls_of(merges, kPartFactors[i] * part * all_cells, lowest);
    std::copy_if(walls[i].begin(), walls[i].end(), std::back_inserter(ends),
                 [&](double wall) { return wall <= strongest; });
  }
  std::sort(ends.begin(), ends.end(), std::greater<>());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());

  std::vector<DeltaCandidate> gaps;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    DeltaCandidate gap{ends[i], ends[i - 1], 0, 0, part, 0};
    for (const auto &list : walls) {
      const auto below = std::lower_bound(list.begin(), list.end(), gap.low, std::greater<>());
      if (below != list.begin())
        gap.width += std::log(*(below - 1) / *below) / static_cast<double>(walls.size());
    }
    gaps.push_back(gap);
  }
  return gaps;
}

/// The widest gap, then the others in which delta can be rounded: what is narrower is a hair between two walls.
std::vector<DeltaCandidate> widest_first(std::vector<DeltaCandidate> gaps)
{
  std::stable_sort(gaps.begin(), gaps.end(), [](const auto &a, const auto &b) { return a.width > b.width; });
  const auto narrow = [](const DeltaCandidate &gap) { return !(gap.high > kRounding * gap.low); };
  gaps.erase(std::remove_if(gaps.begin() + 1, gaps.end(), narrow), gaps.end());
  return gaps;
}

double short_number_in(const DeltaCandidate &gap, double place)
{
  const double there = gap.low * std::pow(gap.high / gap.low, place);
  return short_number_between(std::max(gap.low, there / kRounding), std::min(gap.high, there * kRounding));
}

} // namespace

std::vector<Merge> list_merges(const Hierarchy &hierarchy)
{
  std::vector<Merge> merges;
  auto cells = hierarchy.cell_counts; // of a basin and all that has merged with it
  for (std::size_t rank = hierarchy.basin_count(); rank-- > 1;) {
    const BasinId basin = hierarchy.by_rank[rank];
    std::int64_t &elder_cells = cells[hierarchy.ancestor[basin]];
    merges.push_back({static_cast<double>(hierarchy.persistence[basin]), std::min(cells[basin], elder_cells)});
    elder_cells += cells[basin];
  }
  std::reverse(merges.begin(), merges.end());
  return merges;
}

std::vector<DeltaCandidate> find_delta_candidates(const Hierarchy &hierarchy, double noise_in_gradient,
                                                  std::size_t most, double place)
{
  const std::vector<Merge> merges = list_merges(hierarchy);
  double all_cells = 0;
  for (const std::int64_t cells : hierarchy.cell_counts)
    all_cells += static_cast<double>(cells);

  double noise = kNoiseMerges * noise_in_gradient;
  double part = kFirstPart;
  auto strongest = strongest_of(merges, part * all_cells);
  if (!(strongest > kStandsOut * noise))
    noise = kNoiseFloor * noise_in_gradient;
  while (!(strongest > noise) && part * all_cells > 1) {
    part *= kNextPart;
    strongest = strongest_of(merges, part * all_cells);
  }
  if (!(strongest > noise))
    return {};

  const double lowest = std::max(noise, strongest / kLargestRatio);
  auto candidates = widest_first(measure_gaps(merges, all_cells, part, strongest, lowest));
  candidates.resize(std::min(candidates.size(), most));
  for (DeltaCandidate &candidate : candidates) {
    candidate.delta = short_number_in(candidate, place);
    candidate.regions = hierarchy.region_count(candidate.delta);
  }
  return candidates;
}

double short_number_between(double low, double high)
{
  const double middle = std::sqrt(low) * std::sqrt(high);
  for (int digits = 1; digits < 17; ++digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*e", digits - 1, middle);
    const double number = std::strtod(text, nullptr);
    if (number > low && number <= high)
      return number;
  }
  return high;
}

} // namespace volsurf
