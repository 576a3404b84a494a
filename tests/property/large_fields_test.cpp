// Fields made for one step of the merge each, larger than the random ones.
#include "support/fields.h"
#include "support/merge_of_field.h"

#include <gtest/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

/// At no more than about 20 deltas, as the oracle takes its time.
void expect_kruskals_partition(const Field &field, const std::vector<std::int64_t> &tile_planes)
{
  for (const Exterior exterior : {Exterior::none, Exterior::infinite}) {
    const auto tree = naive_tree(field, exterior);
    const auto deltas = deltas_that_matter(positive_persistences(tree));
    for (const std::int64_t planes : tile_planes) {
      const RegionMerge merge = merge_of(field, exterior, {planes, planes + 1});
      for (std::size_t i = 0; i < deltas.size(); i += 1 + deltas.size() / 20)
        EXPECT_EQ(partition_of(merge, deltas[i]), naive_partition(tree, node_count(field, exterior), deltas[i]))
            << "delta " << deltas[i] << ", " << planes << " planes per tile";
    }
  }
}

template <typename ValueAt> Field field_of(const Index3 &size, ValueAt value_at)
{
  Field field{size, {}};
  for_each_sample(size, [&](const Index3 &p, SampleId) { field.values.push_back(value_at(p)); });
  return field;
}

/// A path of one sample's width through a volume: up and down in z, between rows that it does not touch.
Field winding_path(const Index3 &size)
{
  return field_of(size, [&](const Index3 &p) {
    const std::int64_t last = size[2] - 1;
    const bool on_rise = p[0] % 4 == 0 && p[1] == 1;
    const bool on_turn = p[1] == 1 && p[2] == (p[0] / 4 % 2 == 0 ? last : 0);
    // Along the path I falls by one per sample, so that the steps of all its cells lead to the start.
    const std::int64_t way = p[0] / 4 * (last + 4) + p[0] % 4 + (p[0] / 4 % 2 == 0 ? p[2] : last - p[2]);
    return on_rise || on_turn ? -static_cast<float>(way) : -1e6F;
  });
}

} // namespace

TEST(LargeFields, PlateausOverWholeSlabs)
{
  Dice dice(1);
  const Field field = field_of({20, 17, 24}, [&](const Index3 &p) {
    return p[2] / 8 == 1 ? -2.0F : -static_cast<float>(dice.between(0, 5)) - (p[2] < 8 ? 0.0F : 2.5F);
  });
  expect_kruskals_partition(field, {1, 4, 8, 24});
}

TEST(LargeFields, ConstantVolumeIsOneBasin)
{
  const Field field = field_of({33, 18, 21}, [](const Index3 &) { return -1.0F; });
  EXPECT_EQ(merge_of(field, Exterior::none, {4, 5}).hierarchy.basin_count(), 1U);
  expect_kruskals_partition(field, {1, 5, 32});
}

TEST(LargeFields, LargePlateausOfFewLevels)
{
  Dice dice(2);
  std::vector<float> levels;
  for (int i = 0; i < 64; ++i)
    levels.push_back(-static_cast<float>(dice.between(0, 3)));
  const Field field = field_of({24, 22, 20}, [&](const Index3 &p) {
    return levels[static_cast<std::size_t>(p[0] / 6 + 4 * (p[1] / 6) + 16 * (p[2] / 6))];
  });
  expect_kruskals_partition(field, {1, 6, 32});
}

TEST(LargeFields, VolumesThinnerThanASlab)
{
  Dice dice(3);
  for (const Index3 &size : {Index3{40, 40, 2}, {40, 2, 40}, {2, 40, 40}, {2, 2, 90}, {130, 2, 2}, {2, 130, 2}}) {
    const Field field = field_of(size, [&](const Index3 &) { return -static_cast<float>(dice.between(0, 40)); });
    expect_kruskals_partition(field, {1, 3, 32});
  }
}

TEST(LargeFields, LongPathThroughManySlabs)
{
  const Field field = winding_path({25, 3, 30});
  EXPECT_EQ(merge_of(field, Exterior::none, {3, 2}).hierarchy.basin_count(), 1U);
  expect_kruskals_partition(field, {1, 2, 7, 30});
}

TEST(LargeFields, NoiseOfManyLevels)
{
  Dice dice(4);
  const Field field =
      field_of({30, 29, 28}, [&](const Index3 &) { return -static_cast<float>(dice.between(0, 100000)); });
  expect_kruskals_partition(field, {1, 5, 32});
}

TEST(LargeFields, PeaksThatMeetInTheirStars)
{
  Dice dice(5);
  const Field field = field_of({26, 26, 26}, [&](const Index3 &) {
    return static_cast<float>(dice.between(0, 9999)) / 64.0F - (dice.one_in(8) ? 200.0F : 500.0F);
  });
  expect_kruskals_partition(field, {3, 32});
}
