// delta_study: how good delta is that volsurf chooses for a scan whose truth is known; prints JSON.
//
// The scan is merged once; the Dice coefficient against the truth is then known for every delta. scripts/
// automatic_delta.py runs this over many scans and makes docs/automatic_delta.md of it.
#include "benchmark/measured_run.h"
#include "benchmark/truth.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"
#include "volsurf/phantom/noise.h"
#include "volsurf/pipeline/decide_delta.h"
#include "volsurf/pipeline/merged_volume.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace {

using namespace volsurf;
using namespace volsurf::bench;

constexpr double kLowestDelta = 0.002; ///< that is looked at, of the largest persistence
constexpr int kSamples = 400;          ///< of the curve, evenly spaced in the logarithm of delta
constexpr double kSmallestPart = 5e-4; ///< of the cells: merges of less are not printed
constexpr double kTolerance = 0.02;    ///< of Dice, within which a delta is as good as the best

struct Arguments {
  std::filesystem::path scan;
  std::string truth;
  std::filesystem::path truth_file;
  std::string noise = "none";
  std::uint64_t noise_seed = 1;
  std::vector<double> seed_mm;
  std::optional<double> sigma_mm;
  int threads = 0;
};

void add_options(CLI::App &app, Arguments &arguments)
{
  app.add_option("FILE", arguments.scan, "The scan, of any format that volsurf reads")->required();
  app.add_option("--truth", arguments.truth,
                 "What is right: values:V,... (samples with these values), from:V (of V and more), filled:V (the same "
                 "with the holes of each slice) or largest:V (of those of V and more, the largest connected part)")
      ->required();
  app.add_option("--truth-file", arguments.truth_file, "A volume on the scan's grid that --truth is about (the scan)");
  app.add_option("--noise", arguments.noise, "Noise to add after that: impulse:5%, gaussian:5%, ... of the range");
  app.add_option("--noise-seed", arguments.noise_seed, "Seed of the noise")->capture_default_str();
  app.add_option("--seed", arguments.seed_mm,
                 "The region at this point, in LPS mm, is compared (the hull of the largest part)")
      ->delimiter(',')
      ->expected(3);
  app.add_option("--sigma", arguments.sigma_mm, "Gaussian of the gradient in mm (the smallest spacing)");
  app.add_option("--threads", arguments.threads, "Threads; 0: all")->capture_default_str();
}

CellMask read_truth(const Arguments &arguments, const Volume &scan)
{
  const TruthRule rule = parse_truth(arguments.truth);
  if (arguments.truth_file.empty())
    return find_truth(scan, rule);
  const Volume volume = read_volume(arguments.truth_file).volume;
  if (volume.grid.size != scan.grid.size)
    throw InputError(arguments.truth_file.string() + ": found another size than that of the scan");
  return find_truth(volume, rule);
}

void add_noise_to(Volume &scan, const Arguments &arguments)
{
  const auto [low, high] = std::minmax_element(scan.samples.begin(), scan.samples.end());
  NoiseOptions noise = parse_noise(arguments.noise, static_cast<double>(*high) - static_cast<double>(*low));
  noise.seed = arguments.noise_seed;
  add_noise(scan, noise);
}

BasinId basin_at(const std::vector<double> &point_mm, const MergedVolume &merged)
{
  const Vec3 index = world_to_index(merged.input.volume.grid, {point_mm[0], point_mm[1], point_mm[2]});
  const CellLabels &cells = merged.merge.cells;
  std::int64_t cell = 0;
  for (std::size_t axis = 3; axis-- > 0;) {
    const double position = std::floor(index[axis]);
    if (!(position >= 0 && position < static_cast<double>(cells.size[axis])))
      throw UsageError("--seed: it lies outside the volume");
    cell = cell * cells.size[axis] + static_cast<std::int64_t>(position);
  }
  return cells.basins[cell];
}

DiceCurve compare(const MergedVolume &merged, const CellMask &truth, const std::vector<double> &seed_mm)
{
  const double lowest = kLowestDelta * static_cast<double>(merged.merge.hierarchy.largest_persistence());
  return seed_mm.empty() ? hull_dice(merged.merge, truth, lowest)
                         : region_dice(merged.merge, truth, basin_at(seed_mm, merged), lowest);
}

/// A delta with its regions and Dice.
nlohmann::json judged(double delta, const Hierarchy &hierarchy, const DiceCurve &curve)
{
  return {{"delta", delta}, {"regions", hierarchy.region_count(delta)}, {"dice", dice_at(curve, delta)}};
}

/// The best step of the curve, and the range around it whose Dice is not much less.
nlohmann::json best_of(const DiceCurve &curve, const Hierarchy &hierarchy)
{
  const double lowest = kLowestDelta * static_cast<double>(hierarchy.largest_persistence());
  const auto low_of = [&](auto step) { return step + 1 == curve.end() ? lowest : (step + 1)->delta; };
  const auto high_of = [&](auto step) {
    return std::min(step->delta, static_cast<double>(hierarchy.largest_persistence()));
  };
  const auto best = std::max_element(curve.begin() + 1, curve.end(),
                                     [](const DiceStep &a, const DiceStep &b) { return a.dice < b.dice; });
  auto first = best;
  auto last = best;
  while (first - 1 != curve.begin() && (first - 1)->dice >= best->dice - kTolerance)
    --first;
  while (last + 1 != curve.end() && (last + 1)->dice >= best->dice - kTolerance)
    ++last;
  nlohmann::json result = judged(short_number_between(low_of(best), high_of(best)), hierarchy, curve);
  result["within"] = {low_of(last), high_of(first)};
  return result;
}

nlohmann::json candidates_of(const DeltaAdvice &advice, const Hierarchy &hierarchy, const DiceCurve &curve)
{
  nlohmann::json candidates = nlohmann::json::array();
  for (const DeltaCandidate &candidate : advice.candidates) {
    candidates.push_back(judged(candidate.delta, hierarchy, curve));
    candidates.back().update({{"low", candidate.low}, {"high", candidate.high}, {"part", candidate.part}});
  }
  return candidates;
}

/// delta, regions, Dice.
nlohmann::json samples_of(const DiceCurve &curve, const Hierarchy &hierarchy)
{
  nlohmann::json samples = nlohmann::json::array();
  for (int i = 0; i < kSamples; ++i) {
    const double delta =
        static_cast<double>(hierarchy.largest_persistence()) * std::pow(kLowestDelta, i / (kSamples - 1.0));
    samples.push_back({delta, hierarchy.region_count(delta), dice_at(curve, delta)});
  }
  return samples;
}

/// Persistence, and the smaller side's part of all cells.
nlohmann::json large_merges(const Hierarchy &hierarchy, std::size_t cells)
{
  nlohmann::json merges = nlohmann::json::array();
  for (const Merge &merge : list_merges(hierarchy)) {
    const double part = static_cast<double>(merge.cells) / static_cast<double>(cells);
    if (part >= kSmallestPart &&
        merge.persistence >= kLowestDelta * static_cast<double>(hierarchy.largest_persistence()))
      merges.push_back({merge.persistence, part});
  }
  return merges;
}

void study(const Arguments &arguments)
{
  const ThreadLimit limit(arguments.threads);
  MergedVolume merged;
  merged.input = read_volume(arguments.scan);
  merged.field.sigma_mm = arguments.sigma_mm;
  Volume &scan = merged.input.volume;
  const CellMask truth = read_truth(arguments, scan);
  add_noise_to(scan, arguments);
  merge_input(merged);

  const EdgeField field(scan, merged.field);
  const Hierarchy &hierarchy = merged.merge.hierarchy;
  const DeltaAdvice advice =
      advise_on_delta(merged, field, arguments.seed_mm.empty() ? SurfaceKind::hull : SurfaceKind::all);
  if (advice.candidates.empty())
    throw EmptyResult(arguments.scan.string() + ": found no wall that stands out");
  const DiceCurve curve = compare(merged, truth, arguments.seed_mm);
  if (curve.size() < 2)
    throw EmptyResult("--truth " + arguments.truth + ": found nothing of it at any delta");
  const nlohmann::json result{{"size", scan.grid.size},
                              {"noise", advice.noise.volume},
                              {"noise_in_gradient", advice.noise.gradient},
                              {"noise_floor", advice.noise_floor},
                              {"place", advice.place_in_gap},
                              {"largest_persistence", hierarchy.largest_persistence()},
                              {"candidates", candidates_of(advice, hierarchy, curve)},
                              {"best", best_of(curve, hierarchy)},
                              {"curve", samples_of(curve, hierarchy)},
                              {"merges", large_merges(hierarchy, truth.size())}};
  std::cout << result.dump() << '\n';
}

} // namespace

int main(int argc, char **argv)
{
  CLI::App app("Compares the deltas that volsurf chooses for a scan with the best one, where the truth is known.",
               "delta_study");
  Arguments arguments;
  add_options(app, arguments);
  return run_program(app, argc, argv, [&] { study(arguments); });
}
