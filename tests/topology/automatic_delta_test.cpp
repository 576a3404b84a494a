#include "volsurf/topology/automatic_delta.h"

#include "support/fields.h"
#include "support/merge_of_field.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

struct Part {
  float persistence;
  std::int64_t cells;
};

constexpr std::int64_t kAllCells = 1000000;
constexpr double kMiddle = 0.5; // of a gap, in the logarithm

/// A region without end and what merges with it, one after the other.
Hierarchy hierarchy_of(const std::vector<Part> &parts)
{
  Hierarchy hierarchy;
  std::int64_t rest = kAllCells;
  for (const Part &part : parts)
    rest -= part.cells;
  const auto add = [&](float persistence, std::int64_t cells) {
    const auto basin = static_cast<BasinId>(hierarchy.persistence.size());
    hierarchy.persistence.push_back(persistence);
    hierarchy.ancestor.push_back(0);
    hierarchy.by_rank.push_back(basin);
    hierarchy.rank.push_back(basin);
    hierarchy.cell_counts.push_back(cells);
  };
  add(std::numeric_limits<float>::infinity(), rest);
  for (const Part &part : parts)
    add(part.persistence, part.cells);
  return hierarchy;
}

/// An organ of 12 %, texture of large regions below a persistence of 10, and strong specks.
Hierarchy organ(float scale = 1)
{
  return hierarchy_of({{90 * scale, 20},
                       {47 * scale, 120000},
                       {30 * scale, 900},
                       {10 * scale, 30000},
                       {9 * scale, 40000},
                       {8 * scale, 25000},
                       {7 * scale, 50000},
                       {6 * scale, 10}});
}

/// The basin of the `survivors` strongest that holds a basin.
BasinId survivor_of(const Hierarchy &hierarchy, BasinId basin, std::size_t survivors)
{
  while (hierarchy.rank[basin] >= survivors)
    basin = hierarchy.ancestor[basin];
  return basin;
}

} // namespace

RC_GTEST_PROP(ListMerges, EachHasTheSizeOfTheSmallerOfTheRegionsThatMerge, ())
{
  const Field field = *random_field(5);
  const RegionMerge merge = merge_of(field, *rc::gen::element(Exterior::none, Exterior::infinite));
  const Hierarchy &hierarchy = merge.hierarchy;
  const std::vector<Merge> merges = list_merges(hierarchy);
  RC_ASSERT(merges.size() + 1 == hierarchy.basin_count());
  for (std::size_t rank = 1; rank < hierarchy.basin_count(); ++rank) {
    std::vector<std::int64_t> cells(hierarchy.basin_count());
    for (BasinId basin = 0; basin < hierarchy.basin_count(); ++basin)
      cells[survivor_of(hierarchy, basin, rank + 1)] += hierarchy.cell_counts[basin];
    const BasinId younger = hierarchy.by_rank[rank];
    const BasinId elder = survivor_of(hierarchy, hierarchy.ancestor[younger], rank);
    RC_ASSERT(merges[rank - 1].cells == std::min(cells[younger], cells[elder]));
    RC_ASSERT(merges[rank - 1].persistence == static_cast<double>(hierarchy.persistence[younger]));
  }
}

RC_GTEST_PROP(FindDeltaCandidates, LieAboveTheNoiseAndLeaveTheRegionsThatTheyTell, ())
{
  const Field field = *random_field();
  const RegionMerge merge = merge_of(field, Exterior::none);
  const double noise = 0.1 * *rc::gen::inRange(0, 30);
  const auto candidates = find_delta_candidates(merge.hierarchy, noise, 5, kMiddle);
  RC_ASSERT(candidates.size() <= 5U);
  RC_ASSERT(noise > 0 || candidates.empty() == !(merge.hierarchy.largest_persistence() > 0));
  for (const DeltaCandidate &candidate : candidates) {
    RC_ASSERT(candidate.low >= 0.7 * noise);
    RC_ASSERT(candidate.low < candidate.delta);
    RC_ASSERT(candidate.delta <= candidate.high);
    RC_ASSERT(candidate.high <= merge.hierarchy.largest_persistence());
    RC_ASSERT(candidate.regions == cut(merge.hierarchy, candidate.delta).count());
    RC_ASSERT(candidate.regions >= 2U);
    RC_ASSERT(candidate.width <= candidates.front().width);
  }
}

TEST(FindDeltaCandidates, TheBestIsInTheWidestGapBetweenLargeRegionsWhateverSpecksThereAre)
{
  const auto candidates = find_delta_candidates(organ(), 0.1, 5, kMiddle);
  ASSERT_FALSE(candidates.empty());
  EXPECT_EQ(candidates.front().low, 10);
  EXPECT_EQ(candidates.front().high, 47);
  EXPECT_EQ(candidates.front().delta, 22); // the middle is 21.7
  EXPECT_EQ(candidates.front().regions, 4U);
}

TEST(FindDeltaCandidates, AnotherPlaceInTheGapsMovesDeltaAlone)
{
  const auto middles = find_delta_candidates(organ(), 0.1, 5, kMiddle);
  const auto highs = find_delta_candidates(organ(), 0.1, 5, 0.85);
  ASSERT_EQ(highs.size(), middles.size());
  for (std::size_t i = 0; i < highs.size(); ++i) {
    EXPECT_EQ(highs[i].low, middles[i].low);
    EXPECT_EQ(highs[i].high, middles[i].high);
    EXPECT_EQ(highs[i].width, middles[i].width);
    EXPECT_GT(highs[i].delta, middles[i].delta);
    EXPECT_LE(highs[i].delta, highs[i].high);
  }
  EXPECT_EQ(highs.front().delta, 37); // 10 * 4.7^0.85 is 37.3
}

TEST(FindDeltaCandidates, FollowTheUnitOfIntensity)
{
  const auto expected = find_delta_candidates(organ(), 1, 5, kMiddle);
  const auto scaled = find_delta_candidates(organ(1024), 1024, 5, kMiddle);
  ASSERT_EQ(scaled.size(), expected.size());
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    EXPECT_EQ(scaled[i].low, 1024 * expected[i].low);
    EXPECT_EQ(scaled[i].high, 1024 * expected[i].high);
    EXPECT_EQ(scaled[i].regions, expected[i].regions);
  }
}

TEST(FindDeltaCandidates, HoldTheNeighboursOfTheBestButNoHairBetweenTwoWalls)
{
  // A large organ, a small one that it outlasts, and two parts that are gone almost at once.
  const auto candidates = find_delta_candidates(
      hierarchy_of({{29, 120000}, {17, 12000}, {12, 90000}, {11.9F, 80000}, {9, 50000}}), 12, 5, kMiddle);
  ASSERT_GE(candidates.size(), 2U);
  EXPECT_EQ(candidates[0].low, 17);
  EXPECT_EQ(candidates[0].high, 29);
  EXPECT_EQ(candidates[1].low, 12);
  EXPECT_EQ(candidates[1].high, 17);
  for (const DeltaCandidate &candidate : candidates)
    EXPECT_NE(candidate.high, 12) << "11.9 to 12";
}

TEST(FindDeltaCandidates, NoiseEndsTheGaps)
{
  const auto candidates = find_delta_candidates(organ(), 20, 5, kMiddle); // its large regions merge below 14
  ASSERT_FALSE(candidates.empty());
  EXPECT_EQ(candidates.front().low, 0.7 * 20);
  EXPECT_EQ(candidates.front().high, 47);
  EXPECT_TRUE(find_delta_candidates(organ(), 200, 5, kMiddle).empty());
}

TEST(FindDeltaCandidates, WhereNoLargeRegionStandsOutSmallerOnesCount)
{
  const auto candidates = find_delta_candidates(hierarchy_of({{40, 300}, {4, 500}, {3, 300}}), 0.1, 5, kMiddle);
  ASSERT_FALSE(candidates.empty());
  EXPECT_EQ(candidates.front().low, 4);
  EXPECT_EQ(candidates.front().high, 40);
  EXPECT_LT(candidates.front().part, 0.001);
}

TEST(FindDeltaCandidates, LargeRegionsThatAreOnlyNoiseDoNotHideASmallOne)
{
  const auto candidates =
      find_delta_candidates(hierarchy_of({{14, 3000}, {0.72F, 30000}, {0.71F, 40000}}), 1, 5, kMiddle);
  ASSERT_FALSE(candidates.empty());
  EXPECT_EQ(candidates.front().low, 1.7);
  EXPECT_EQ(candidates.front().high, 14);
}

TEST(FindDeltaCandidates, AFieldWithoutWallsHasNone)
{
  EXPECT_TRUE(find_delta_candidates(hierarchy_of({}), 0, 5, kMiddle).empty());
  EXPECT_TRUE(find_delta_candidates(hierarchy_of({{0, 100000}}), 0, 5, kMiddle).empty());
}

TEST(ShortNumberBetween, HasAsFewDigitsAsFitNearTheMiddle)
{
  EXPECT_EQ(short_number_between(3.9, 4.2), 4);
  EXPECT_EQ(short_number_between(0.81, 0.89), 0.85);
  EXPECT_EQ(short_number_between(123.2, 123.4), 123.3);
  EXPECT_EQ(short_number_between(1, 1.5e6), 1000);
}

RC_GTEST_PROP(ShortNumberBetween, LiesAboveLowAndUpToHigh, ())
{
  const double low = std::exp(0.01 * *rc::gen::inRange(-2000, 2000));
  const double high =
      *rc::gen::arbitrary<bool>() ? std::nextafter(low, 2 * low) : low * (1 + 0.001 * *rc::gen::inRange(1, 3000));
  const double number = short_number_between(low, high);
  RC_ASSERT(number > low);
  RC_ASSERT(number <= high);
}
