#include "benchmark/dice_curve.h"

#include "support/fields.h"
#include "support/merge_of_field.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

using namespace volsurf;
using namespace volsurf::bench;
using namespace volsurf::support;

namespace {

CellMask random_mask(std::size_t cells)
{
  return *rc::gen::container<CellMask>(cells, rc::gen::element<std::uint8_t>(0, 1));
}

double dice_of(const std::vector<bool> &found, const CellMask &truth)
{
  std::int64_t both = 0;
  std::int64_t sum = 0;
  for (std::size_t cell = 0; cell < truth.size(); ++cell) {
    both += found[cell] && truth[cell] ? 1 : 0;
    sum += (found[cell] ? 1 : 0) + truth[cell];
  }
  return sum > 0 ? 2 * static_cast<double>(both) / static_cast<double>(sum) : 0;
}

std::vector<bool> cells_of(const RegionMerge &merge, const std::function<bool(BasinId)> &holds)
{
  std::vector<bool> result;
  for (const BasinId basin : merge.cells.basins)
    result.push_back(holds(basin));
  return result;
}

/// Per cell the lowest cell that it is connected to within `mask`: neighbours tell each other until nothing changes.
std::vector<std::size_t> parts_of(const std::vector<bool> &mask, const Index3 &size)
{
  std::vector<std::size_t> part(mask.size());
  std::iota(part.begin(), part.end(), std::size_t{0});
  const auto stride_y = static_cast<std::size_t>(size[0]);
  const auto stride_z = static_cast<std::size_t>(size[0] * size[1]);
  for (bool changed = true; changed;) {
    changed = false;
    const auto meet = [&](bool exists, std::size_t a, std::size_t b) {
      if (!exists || !mask[a] || !mask[b] || part[a] == part[b])
        return;
      part[a] = part[b] = std::min(part[a], part[b]);
      changed = true;
    };
    for (std::size_t cell = 0; cell < mask.size(); ++cell) {
      meet((cell + 1) % stride_y != 0, cell, cell + 1);
      meet(cell / stride_y % static_cast<std::size_t>(size[1]) + 1 < static_cast<std::size_t>(size[1]), cell,
           cell + stride_y);
      meet(cell + stride_z < mask.size(), cell, cell + stride_z);
    }
  }
  return part;
}

/// Dice of each of the parts of `mask` that have the most cells; of nothing where the mask is empty.
std::vector<double> dice_of_largest_parts(const std::vector<bool> &mask, const Index3 &size, const CellMask &truth)
{
  const auto part = parts_of(mask, size);
  std::map<std::size_t, std::vector<bool>> members;
  for (std::size_t cell = 0; cell < mask.size(); ++cell)
    if (mask[cell])
      members.try_emplace(part[cell], mask.size()).first->second[cell] = true;
  std::ptrdiff_t most = 0;
  std::vector<double> result{dice_of(std::vector<bool>(mask.size()), truth)};
  for (const auto &[lowest, cells] : members) {
    const auto count = std::count(cells.begin(), cells.end(), true);
    if (count > most)
      result.clear();
    if (count >= most)
      result.push_back(dice_of(cells, truth));
    most = std::max(most, count);
  }
  return result;
}

} // namespace

RC_GTEST_PROP(HullDice, IsThatOfTheLargestPartOutsideOfTheBackgroundAtEveryDelta, ())
{
  const RegionMerge merge = merge_of(*random_field(6), *rc::gen::element(Exterior::none, Exterior::infinite));
  const CellMask truth = random_mask(static_cast<std::size_t>(merge.cells.basins.size()));
  const DiceCurve curve = hull_dice(merge, truth, 0);
  for (const float delta : deltas_that_matter(positive_persistences(merge.hierarchy))) {
    const Regions regions = cut(merge.hierarchy, delta);
    const RegionId background = regions.of_basin[merge.hierarchy.background];
    const auto inside = cells_of(merge, [&](BasinId basin) { return regions.of_basin[basin] != background; });
    const auto expected = dice_of_largest_parts(inside, merge.cells.size, truth);
    RC_ASSERT(std::find(expected.begin(), expected.end(), dice_at(curve, delta)) != expected.end());
  }
}

RC_GTEST_PROP(RegionDice, IsThatOfTheRegionOfABasinAtEveryDelta, ())
{
  const RegionMerge merge = merge_of(*random_field(6), *rc::gen::element(Exterior::none, Exterior::infinite));
  const CellMask truth = random_mask(static_cast<std::size_t>(merge.cells.basins.size()));
  const BasinId seed = *rc::gen::inRange<BasinId>(0, static_cast<BasinId>(merge.hierarchy.basin_count()));
  const DiceCurve curve = region_dice(merge, truth, seed, 0);
  for (const float delta : deltas_that_matter(positive_persistences(merge.hierarchy))) {
    const Regions regions = cut(merge.hierarchy, delta);
    const auto region =
        cells_of(merge, [&](BasinId basin) { return regions.of_basin[basin] == regions.of_basin[seed]; });
    RC_ASSERT(dice_at(curve, delta) == dice_of(region, truth));
  }
}

RC_GTEST_PROP(DiceCurve, IsTheSameAboveTheLowestDeltaThatIsAskedFor, ())
{
  const RegionMerge merge = merge_of(*random_field(6), Exterior::none);
  const CellMask truth = random_mask(static_cast<std::size_t>(merge.cells.basins.size()));
  const double lowest = 0.3 * static_cast<double>(merge.hierarchy.largest_persistence());
  const DiceCurve all = region_dice(merge, truth, 0, 0);
  const DiceCurve upper = region_dice(merge, truth, 0, lowest);
  for (const float delta : deltas_that_matter(positive_persistences(merge.hierarchy)))
    if (static_cast<double>(delta) >= lowest)
      RC_ASSERT(dice_at(upper, delta) == dice_at(all, delta));
  RC_ASSERT(upper.back().delta >= lowest);
}
