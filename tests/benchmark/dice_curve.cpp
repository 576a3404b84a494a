#include "benchmark/dice_curve.h"

#include "volsurf/core/index_forest.h"

#include <algorithm>
#include <limits>

namespace volsurf::bench {

namespace {

struct Counts {
  std::int64_t cells = 0;
  std::int64_t truth = 0; ///< those of them that are true
};

Counts operator+(const Counts &a, const Counts &b)
{
  return {a.cells + b.cells, a.truth + b.truth};
}

Counts operator-(const Counts &a, const Counts &b)
{
  return {a.cells - b.cells, a.truth - b.truth};
}

/// The basins, each with the largest delta at which it is in another region than a given one.
struct Leaving {
  Leaving(const RegionMerge &merge, const CellMask &truth, BasinId from, double lowest);

  std::vector<float> delta;    ///< per basin; 0 for the given one
  std::vector<Counts> counts;  ///< per basin
  std::vector<BasinId> basins; ///< those that leave at `lowest` or above it, by decreasing delta
  Counts all;
};

Leaving::Leaving(const RegionMerge &merge, const CellMask &truth, BasinId from, double lowest)
    : counts(merge.hierarchy.basin_count())
{
  std::size_t cell = 0;
  for (const BasinId basin : merge.cells.basins)
    counts[basin] = counts[basin] + Counts{1, truth[cell++]};
  for (BasinId basin = 0; basin < counts.size(); ++basin) {
    delta.push_back(saliency(merge.hierarchy, from, basin));
    all = all + counts[basin];
    if (delta[basin] > 0 && static_cast<double>(delta[basin]) >= lowest)
      basins.push_back(basin);
  }
  std::sort(basins.begin(), basins.end(), [&](BasinId a, BasinId b) { return delta[a] > delta[b]; });
}

/// Two basins that share a face are connected at this delta and below.
struct Contact {
  float delta;
  BasinId a;
  BasinId b;
};

/// By decreasing delta. Neighbouring faces between the same basins are one contact.
std::vector<Contact> find_contacts(const CellLabels &cells, const std::vector<float> &leaves_at, double lowest)
{
  std::vector<Contact> contacts;
  const Index3 stride{1, cells.size[0], cells.size[0] * cells.size[1]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    BasinId last_a = 0;
    BasinId last_b = 0;
    const std::int64_t count = static_cast<std::int64_t>(cells.basins.size()) - stride[axis];
    for (std::int64_t cell = 0; cell < count; ++cell) {
      const BasinId a = cells.basins[cell];
      const BasinId b = cells.basins[cell + stride[axis]];
      if (a == b || (a == last_a && b == last_b) || cell / stride[axis] % cells.size[axis] + 1 == cells.size[axis])
        continue;
      last_a = a;
      last_b = b;
      const float delta = std::min(leaves_at[a], leaves_at[b]);
      if (delta > 0 && static_cast<double>(delta) >= lowest)
        contacts.push_back({delta, a, b});
    }
  }
  std::sort(contacts.begin(), contacts.end(), [](const Contact &a, const Contact &b) { return a.delta > b.delta; });
  return contacts;
}

double dice_of(const Counts &found, const Counts &all)
{
  return all.truth + found.cells > 0
             ? 2 * static_cast<double>(found.truth) / static_cast<double>(found.cells + all.truth)
             : 0;
}

/// Adds the step of a delta, unless nothing changes.
void add_step(DiceCurve &curve, double delta, double dice)
{
  if (curve.empty() || dice != curve.back().dice)
    curve.push_back({delta, dice});
}

} // namespace

DiceCurve hull_dice(const RegionMerge &merge, const CellMask &truth, double lowest)
{
  Leaving leaving(merge, truth, merge.hierarchy.background, lowest);
  const std::vector<Contact> contacts = find_contacts(merge.cells, leaving.delta, lowest);
  std::vector<Counts> &part = leaving.counts; // of each representative
  IndexForest parts(static_cast<std::uint32_t>(part.size()));
  Counts largest;
  const auto consider = [&](const Counts &counts) {
    if (counts.cells > largest.cells)
      largest = counts;
  };

  DiceCurve curve;
  add_step(curve, std::numeric_limits<double>::infinity(), dice_of(largest, leaving.all));
  auto contact = contacts.begin();
  for (auto basin = leaving.basins.begin(); basin != leaving.basins.end();) {
    const float delta = leaving.delta[*basin];
    for (; basin != leaving.basins.end() && leaving.delta[*basin] == delta; ++basin)
      consider(part[*basin]);
    for (; contact != contacts.end() && contact->delta == delta; ++contact) {
      const std::uint32_t a = parts.find(contact->a);
      const std::uint32_t b = parts.find(contact->b);
      if (!parts.join(a, b))
        continue;
      Counts &joined = part[parts.find(a)];
      joined = part[a] + part[b];
      consider(joined);
    }
    add_step(curve, static_cast<double>(delta), dice_of(largest, leaving.all));
  }
  return curve;
}

DiceCurve region_dice(const RegionMerge &merge, const CellMask &truth, BasinId seed, double lowest)
{
  const Leaving leaving(merge, truth, seed, lowest);
  Counts region = leaving.all;
  DiceCurve curve;
  add_step(curve, std::numeric_limits<double>::infinity(), dice_of(region, leaving.all));
  for (auto basin = leaving.basins.begin(); basin != leaving.basins.end();) {
    const float delta = leaving.delta[*basin];
    for (; basin != leaving.basins.end() && leaving.delta[*basin] == delta; ++basin)
      region = region - leaving.counts[*basin];
    add_step(curve, static_cast<double>(delta), dice_of(region, leaving.all));
  }
  return curve;
}

double dice_at(const DiceCurve &curve, double delta)
{
  const auto below =
      std::partition_point(curve.begin(), curve.end(), [&](const DiceStep &step) { return step.delta >= delta; });
  return (below - 1)->dice;
}

} // namespace volsurf::bench
