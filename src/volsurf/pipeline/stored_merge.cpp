#include "volsurf/pipeline/stored_merge.h"

#include "volsurf/core/error.h"
#include "volsurf/io/array_file.h"
#include "volsurf/io/output_file.h"
#include "volsurf/pipeline/stored_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace volsurf {

namespace {

constexpr ArrayFileKind kKind{"volsurf hierarchy", 1};
constexpr char kExtension[] = ".volsurf";

/// Integers that fit are stored as such: a third of the bytes, and of the time.
template <typename Integer> bool holds_all(const std::vector<float> &samples)
{
  constexpr auto kLow = static_cast<float>(std::numeric_limits<Integer>::min());
  constexpr auto kHigh = static_cast<float>(std::numeric_limits<Integer>::max());
  return std::all_of(samples.begin(), samples.end(), [](float sample) {
    return sample >= kLow && sample <= kHigh && sample == std::trunc(sample) && !(sample == 0 && std::signbit(sample));
  });
}

template <typename Integer> std::vector<Integer> as_integers(const std::vector<float> &samples)
{
  std::vector<Integer> integers(samples.size());
  std::transform(samples.begin(), samples.end(), integers.begin(),
                 [](float sample) { return static_cast<Integer>(sample); });
  return integers;
}

template <typename Stored> std::vector<float> read_samples(const ArrayFile &file, std::int64_t count)
{
  std::vector<Stored> stored(static_cast<std::size_t>(count));
  file.read("samples", stored.data(), count);
  if constexpr (std::is_same_v<Stored, float>)
    return stored;
  else
    return {stored.begin(), stored.end()};
}

std::vector<float> read_samples(const ArrayFile &file, std::int64_t count)
{
  switch (file.type_of("samples")) {
  case ElementType::uint8:
    return read_samples<std::uint8_t>(file, count);
  case ElementType::int16:
    return read_samples<std::int16_t>(file, count);
  case ElementType::uint16:
    return read_samples<std::uint16_t>(file, count);
  default:
    return read_samples<float>(file, count);
  }
}

template <typename Use> void with_packed_samples(const std::vector<float> &samples, Use use)
{
  const auto use_values = [&](const auto &values) {
    use(named_array("samples", values.data(), static_cast<std::int64_t>(values.size())));
  };
  if (holds_all<std::uint8_t>(samples))
    use_values(as_integers<std::uint8_t>(samples));
  else if (holds_all<std::int16_t>(samples))
    use_values(as_integers<std::int16_t>(samples));
  else if (holds_all<std::uint16_t>(samples))
    use_values(as_integers<std::uint16_t>(samples));
  else
    use_values(samples);
}

/// The arrays that the others follow from are left out: see derive_arrays.
template <typename Hierarchy, typename Visit> void visit_stored_arrays(Hierarchy &hierarchy, Visit visit)
{
  visit("persistence", hierarchy.persistence);
  visit("ancestor", hierarchy.ancestor);
  visit("by_rank", hierarchy.by_rank);
  visit("roots", hierarchy.roots);
  visit("values", hierarchy.values);
}

Hierarchy read_arrays(const ArrayFile &file, Hierarchy hierarchy)
{
  const std::int64_t basins = file.count_of("persistence");
  visit_stored_arrays(hierarchy, [&](const char *name, auto &array) {
    array.resize(static_cast<std::size_t>(basins));
    file.read(name, array.data(), basins);
  });
  return hierarchy;
}

/// Throws InputError where the file contradicts itself.
class Checker {
public:
  explicit Checker(const std::filesystem::path &path) : path_(path) {}

  void require(bool holds, const std::string &found) const
  {
    if (!holds)
      throw InputError(path_.string() + ": found " + found + "; allowed: what --save-hierarchy wrote");
  }

private:
  const std::filesystem::path &path_;
};

/// by_rank holds each basin once, in the order that cut() relies on.
void check_ranks(const Hierarchy &hierarchy, const Checker &checker)
{
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto &[persistence, by_rank] = std::tie(hierarchy.persistence, hierarchy.by_rank);
  for (const BasinId basin : by_rank)
    checker.require(basin < by_rank.size() && persistence[basin] >= 0, "a rank without a basin or a persistence");
  checker.require(persistence[by_rank[0]] == kInfinity, "no basin that lasts");
  for (std::size_t rank = 1; rank < by_rank.size(); ++rank) {
    const BasinId before = by_rank[rank - 1];
    const BasinId basin = by_rank[rank];
    checker.require(persistence[before] > persistence[basin] ||
                        (persistence[before] == persistence[basin] && before < basin),
                    "basins that are not in the order of their persistence");
  }
}

/// Needs ranks: every way up ends at the first.
void check_ancestors(const Hierarchy &hierarchy, const Checker &checker)
{
  const BasinId top = hierarchy.by_rank[0];
  for (BasinId basin = 0; basin < hierarchy.basin_count(); ++basin) {
    const BasinId ancestor = hierarchy.ancestor[basin];
    checker.require(ancestor < hierarchy.basin_count(), "an ancestor that does not exist");
    checker.require(basin == top ? ancestor == top : hierarchy.rank[ancestor] < hierarchy.rank[basin],
                    "an ancestor that is not before its basin");
  }
}

void check_labels(const CellLabels &cells, std::size_t basins, const Checker &checker)
{
  BasinId largest = 0;
  for (const BasinId basin : cells.basins)
    largest = std::max(largest, basin);
  checker.require(largest < basins, "a cell in a basin that does not exist");
}

/// Needs labels.
void check_roots(const RegionMerge &merge, const Checker &checker)
{
  const Hierarchy &hierarchy = merge.hierarchy;
  for (BasinId basin = 0; basin < hierarchy.basin_count(); ++basin) {
    const CellId root = hierarchy.roots[basin];
    const bool is_exterior = hierarchy.exterior == basin;
    checker.require(is_exterior ? root == -1
                                : root >= 0 && root < merge.cells.basins.size() && merge.cells.basins[root] == basin,
                    "a basin whose root is not in it");
  }
}

void derive_arrays(RegionMerge &merge)
{
  Hierarchy &hierarchy = merge.hierarchy;
  hierarchy.cell_counts.resize(hierarchy.basin_count());
  for (const BasinId basin : merge.cells.basins)
    ++hierarchy.cell_counts[basin];
  hierarchy.rank.resize(hierarchy.basin_count());
  for (std::uint32_t rank = 0; rank < hierarchy.by_rank.size(); ++rank)
    hierarchy.rank[hierarchy.by_rank[rank]] = rank;
}

void check_samples(const std::vector<float> &samples, const Checker &checker)
{
  checker.require(std::all_of(samples.begin(), samples.end(), [](float sample) { return std::isfinite(sample); }),
                  "a sample that is not finite");
}

RegionMerge read_checked_merge(const ArrayFile &file, const MergedVolume &facts, const Checker &checker)
{
  const Grid &grid = facts.input.volume.grid;
  const std::int64_t basins = file.count_of("persistence");
  checker.require(basins > 0 && basins < kFirstStepCode, "a number of basins out of range");
  checker.require(facts.merge.hierarchy.background < basins && facts.merge.hierarchy.exterior.value_or(0) < basins,
                  "a background that is no basin");
  RegionMerge merge{{grid.cell_size(), Buffer<BasinId>(grid.cell_count())}, read_arrays(file, facts.merge.hierarchy)};
  check_ranks(merge.hierarchy, checker);
  file.read("basins", merge.cells.basins.data(), merge.cells.basins.size());
  check_labels(merge.cells, merge.hierarchy.basin_count(), checker);
  check_roots(merge, checker);
  derive_arrays(merge);
  check_ancestors(merge.hierarchy, checker);
  return merge;
}

} // namespace

void require_hierarchy_extension(const std::filesystem::path &path)
{
  require_extension(path, kExtension);
}

void write_merge(const MergedVolume &merged, const std::filesystem::path &path)
{
  std::vector<NamedArray> arrays;
  visit_stored_arrays(merged.merge.hierarchy, [&](const char *name, const auto &array) {
    arrays.push_back(named_array(name, array.data(), static_cast<std::int64_t>(array.size())));
  });
  const auto &basins = merged.merge.cells.basins;
  arrays.push_back(named_array("basins", basins.data(), basins.size()));
  with_packed_samples(merged.input.volume.samples, [&](const NamedArray &samples) {
    arrays.push_back(samples);
    write_array_file(path, kKind, facts_of(merged), arrays);
  });
}

bool is_stored_merge(const std::filesystem::path &path)
{
  return is_array_file(path, kKind);
}

MergedVolume read_merge(const std::filesystem::path &path, const std::function<void(const Grid &)> &check_grid)
{
  const ArrayFile file(path, kKind);
  const Checker checker(path);
  MergedVolume merged = merged_volume_of(file.facts(), path);
  merged.is_stored = true;
  Volume &volume = merged.input.volume;
  if (check_grid)
    check_grid(volume.grid);
  merged.merge = read_checked_merge(file, merged, checker);
  volume.samples = read_samples(file, volume.grid.sample_count());
  check_samples(volume.samples, checker);
  return merged;
}

} // namespace volsurf
