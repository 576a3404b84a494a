#include "volsurf/baseline/isosurface.h"

#include "support/grids.h"

#include "volsurf/core/parallel.h"
#include "volsurf/surface/check.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr double kPi = 3.14159265358979;
constexpr double kRadius = 9;

/// 100 minus the distance in mm to the middle of a grid of about 25 mm.
Volume cone(Grid grid)
{
  Volume volume;
  Vec3 middle{};
  for (int axis = 0; axis < 3; ++axis) {
    grid.size[axis] = static_cast<std::int64_t>(25 / grid.spacing_mm[axis]);
    middle[axis] = static_cast<double>(grid.size[axis] - 1) / 2;
  }
  volume.grid = grid;
  const Vec3 centre = index_to_world(grid, middle);
  for_each_sample(grid.size, [&](const Index3 &p, SampleId) {
    const Vec3 world =
        index_to_world(grid, {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    const double distance = std::hypot(world[0] - centre[0], world[1] - centre[1], world[2] - centre[2]);
    volume.samples.push_back(static_cast<float>(100 - distance));
  });
  return volume;
}

IsosurfaceFilter any_filter()
{
  return *rc::gen::element(IsosurfaceFilter::flying_edges, IsosurfaceFilter::marching_cubes);
}

} // namespace

RC_GTEST_PROP(Isosurface, OfABallIsWatertightInItsPlaceAndPointsOutwardsOnEveryGrid, ())
{
  Dice dice(*random_seed());
  Grid grid = any_grid(dice);
  for (double &spacing : grid.spacing_mm)
    spacing = 0.75 + spacing / 6;
  const Volume volume = cone(grid);
  const Mesh mesh = isosurface(volume, 100 - kRadius, any_filter());
  const MeshCheck check = check_mesh(mesh);
  RC_ASSERT(check.watertight);
  RC_ASSERT(check.shells == 1);
  RC_ASSERT(check.genus == 0);
  const double true_volume = 4.0 / 3.0 * kPi * kRadius * kRadius * kRadius;
  RC_ASSERT(std::abs(check.volume_mm3 / true_volume - 1) < 0.02);
  Vec3 centre{};
  for (int axis = 0; axis < 3; ++axis)
    centre[axis] = static_cast<double>(volume.grid.size[axis] - 1) / 2;
  centre = index_to_world(volume.grid, centre);
  for (const Point &p : mesh.points)
    RC_ASSERT(std::abs(std::hypot(p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]) - kRadius) < 0.05);
}

TEST(Isosurface, IsOpenWhereItMeetsTheBorder)
{
  const MeshCheck check = check_mesh(isosurface(cone({}), 86));
  EXPECT_FALSE(check.watertight);
  EXPECT_GT(check.open_edges, 0);
}

TEST(Isosurface, IsEmptyBeyondTheRangeOfTheSamples)
{
  for (const double iso : {-1.0, 101.0})
    EXPECT_TRUE(isosurface(cone({}), iso).triangles.empty()) << iso;
}

TEST(Isosurface, IsTheSameForAnyNumberOfThreads)
{
  const Volume volume = cone({});
  const Mesh first = isosurface(volume, 91.25);
  for (const int threads : {1, 2, 5}) {
    const ThreadLimit limit(threads);
    const Mesh mesh = isosurface(volume, 91.25);
    EXPECT_EQ(mesh.points, first.points);
    EXPECT_EQ(mesh.triangles, first.triangles);
  }
}
