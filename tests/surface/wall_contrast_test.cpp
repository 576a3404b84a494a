#include "volsurf/surface/wall_contrast.h"

#include "support/box_mesh.h"
#include "support/fields.h"

#include "volsurf/core/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr std::int64_t kSize = 24;
constexpr double kOutside = 100;
constexpr double kStep = 60;
constexpr double kBeyond = -25;

const Vec3 kOnTheWall{17.3, 12, 11.5};

/// A box in a scan that is the mixture which the model says, and noise of that sd.
ScanModel model_of_box(Inside inside, double noise = 0)
{
  const Volume blank{cube(kSize), std::vector<float>(kSize * kSize * kSize)};
  ScanModel model({{0, 0, 0}, blank.grid, blank.grid.size}, blank, inside);
  model.set_surface(box({5.2, 4.7, 6.1}, {17.3, 18.9, 16.6}));
  Dice dice(5);
  for (std::size_t i = 0; i < model.samples.values.size(); ++i) {
    const auto share = static_cast<double>(model.shares.values[i]);
    const auto beyond = static_cast<double>(model.beyond_shares.values[i]);
    const double error = noise * (dice.one_in(2) ? 1 : -1);
    model.samples.values[i] = static_cast<float>(kOutside + kStep * share + kBeyond * beyond + error);
  }
  return model;
}

} // namespace

TEST(WallContrasts, AreTheIntensitiesThatMadeTheScan)
{
  const WallContrasts contrasts(model_of_box(Inside::layered));
  for (const Vec3 &place : {kOnTheWall, Vec3{5.2, 9, 9}, Vec3{11, 18.9, 16.6}, Vec3{8, 8, 6.1}}) {
    const auto contrast = contrasts.at(place);
    ASSERT_TRUE(contrast);
    EXPECT_NEAR(contrast->outside, kOutside, 0.01);
    EXPECT_NEAR(contrast->step, kStep, 0.01);
    EXPECT_NEAR(contrast->beyond, kBeyond, 0.01);
    EXPECT_NEAR(contrast->left_over, 0, 0.1);
  }
}

TEST(WallContrasts, HaveNothingBeyondALayerWhereThereIsNone)
{
  const auto contrast = WallContrasts(model_of_box(Inside::uniform)).at(kOnTheWall);
  ASSERT_TRUE(contrast);
  EXPECT_EQ(contrast->beyond, 0);
  EXPECT_NEAR(contrast->step, kStep, 0.01);
}

TEST(WallContrasts, LeaveTheNoiseOver)
{
  const auto contrast = WallContrasts(model_of_box(Inside::layered, 7)).at(kOnTheWall);
  ASSERT_TRUE(contrast);
  EXPECT_NEAR(contrast->left_over, 7, 0.5);
  EXPECT_NEAR(contrast->step, kStep, 7);
}

TEST(WallContrasts, SayNothingOfAFlatScanOrWithoutAWall)
{
  ScanModel model = model_of_box(Inside::layered);
  std::fill(model.samples.values.begin(), model.samples.values.end(), 42.0F);
  EXPECT_FALSE(WallContrasts(model).at(kOnTheWall));
  model = model_of_box(Inside::layered);
  std::fill(model.shares.values.begin(), model.shares.values.end(), 1.0F);
  EXPECT_FALSE(WallContrasts(model).at(kOnTheWall));
}

TEST(WallContrasts, LeaveTheOutermostSamplesOfTheScanOut)
{
  ScanModel model = model_of_box(Inside::layered);
  for_each_sample({kSize, kSize, kSize}, [&](const Index3 &p, SampleId) {
    for (const std::int64_t i : p)
      if (i == 0 || i == kSize - 1)
        model.samples.row(p[1], p[2])[p[0]] = std::numeric_limits<float>::quiet_NaN();
  });
  const auto contrast = WallContrasts(model).at(kOnTheWall);
  ASSERT_TRUE(contrast);
  EXPECT_NEAR(contrast->step, kStep, 0.01);
}

TEST(WallContrasts, AreTheSameForAnyNumberOfThreads)
{
  const ScanModel model = model_of_box(Inside::layered, 7);
  const double expected = WallContrasts(model).at(kOnTheWall)->step;
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(WallContrasts(model).at(kOnTheWall)->step, expected);
  }
}
