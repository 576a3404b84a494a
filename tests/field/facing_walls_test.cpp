#include "volsurf/field/facing_walls.h"

#include "support/partial_volumes.h"

#include "volsurf/core/parallel.h"

#include <gtest/gtest.h>

#include <random>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr Index3 kSize{32, 32, 32};

Volume ball()
{
  return scan_of_body(kSize, [](const Vec3 &p) { return std::hypot(p[0] - 15.6, p[1] - 15.7, p[2] - 15.3) - 10.2; });
}

/// A plate, oblique, whose walls are so many voxels apart.
Volume plate(double thickness)
{
  return scan_of_body(
      kSize, [=](const Vec3 &p) { return std::abs(0.8 * (p[0] - 15.5) + 0.6 * (p[1] - 15.5)) - thickness / 2; });
}

Volume with_noise(Volume volume, double sd)
{
  std::mt19937 engine(5);
  std::normal_distribution<double> noise(0, sd);
  for (float &sample : volume.samples)
    sample += static_cast<float>(noise(engine));
  return volume;
}

} // namespace

TEST(PartOfFacingWalls, OfThinPlatesIsLargeAndOfThickBodiesNone)
{
  for (const double noise : {0.0, 10.0, 20.0, 40.0}) {
    EXPECT_GT(part_of_facing_walls(with_noise(plate(2), noise), noise), 0.2) << noise;
    EXPECT_LT(part_of_facing_walls(with_noise(plate(6), noise), noise), 0.02) << noise;
    EXPECT_LT(part_of_facing_walls(with_noise(ball(), noise), noise), 0.02) << noise;
  }
}

TEST(PartOfFacingWalls, OfAFurrowIsThatOfAPlate)
{
  Volume furrow = plate(2);
  for (float &sample : furrow.samples)
    sample = 300 - sample;
  EXPECT_EQ(part_of_facing_walls(furrow, 0), part_of_facing_walls(plate(2), 0));
}

TEST(PartOfFacingWalls, OfWhatHasNoWallsIsNone)
{
  Volume flat;
  flat.grid.size = {5, 4, 3};
  flat.samples.assign(60, 7.0F);
  EXPECT_EQ(part_of_facing_walls(flat, 0), 0);
  flat.grid.size = {30, 1, 2};
  EXPECT_EQ(part_of_facing_walls(flat, 0), 0) << "too thin to tell";
}

TEST(PartOfFacingWalls, IsTheSameForAnyNumberOfThreads)
{
  const Volume volume = with_noise(plate(3), 20);
  const double expected = part_of_facing_walls(volume, 20);
  for (const int threads : {1, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(part_of_facing_walls(volume, 20), expected) << threads;
  }
}
