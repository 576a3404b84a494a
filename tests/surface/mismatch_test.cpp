#include "volsurf/surface/mismatch.h"

#include "support/box_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr std::int64_t kSize = 20;
const Contrast kContrast{100, 60, 0, 0};
const Vec3 kOnTheWall{14.4, 10.2, 9.7};

Mesh box_up_to(double x)
{
  return box({4.2, 3.7, 4.1}, {x, 16.2, 15.6});
}

/// The scan is that of one box, the surface that of another.
ScanModel model_of_boxes(double x_of_scan, double x_of_surface)
{
  const Volume blank{cube(kSize), std::vector<float>(kSize * kSize * kSize)};
  ScanModel model({{0, 0, 0}, blank.grid, blank.grid.size}, blank, Inside::uniform);
  model.set_surface(box_up_to(x_of_scan));
  for (std::size_t i = 0; i < model.samples.values.size(); ++i)
    model.samples.values[i] = static_cast<float>(kContrast.outside + kContrast.step * model.shares.values[i]);
  model.set_surface(box_up_to(x_of_surface));
  return model;
}

} // namespace

TEST(Mismatch, IsHowFarTheWallIsFromWhereItShouldBe)
{
  for (const double way : {-0.4, -0.1, 0.0, 0.2, 0.5}) {
    const auto mismatch = mismatch_at(kOnTheWall, kContrast, {}, model_of_boxes(kOnTheWall[0] + way, kOnTheWall[0]));
    ASSERT_TRUE(mismatch);
    EXPECT_NEAR(mismatch->way, way, 0.03 + 0.25 * std::abs(way)) << way;
    EXPECT_EQ(mismatch->error, 0);
  }
}

TEST(Mismatch, IsAsUncertainAsItsSamples)
{
  const ScanModel model = model_of_boxes(14.4, 14.4);
  const double once = mismatch_at(kOnTheWall, kContrast, {3}, model)->error;
  EXPECT_GT(once, 0);
  EXPECT_NEAR(mismatch_at(kOnTheWall, kContrast, {6}, model)->error, 2 * once, 1e-9);
}

TEST(Mismatch, IsMovedByAnImpulseAsFarAsTheLimitLetsIt)
{
  ScanModel model = model_of_boxes(14.4, 14.4);
  model.samples.row(10, 10)[15] += 600;
  const double free = mismatch_at(kOnTheWall, kContrast, {}, model)->way;
  const double held = mismatch_at(kOnTheWall, kContrast, {0, 15}, model)->way;
  EXPECT_GT(free, 0.5);
  EXPECT_GT(held, 0);
  EXPECT_LT(held, 0.1);
}

TEST(Mismatch, IsUnknownBeyondTheScan)
{
  EXPECT_FALSE(mismatch_at({10, 10, -40}, kContrast, {}, model_of_boxes(14.4, 14.4)));
}
