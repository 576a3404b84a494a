#include "volsurf/baseline/cgal_mesher.h"

#include "support/grids.h"

#include "volsurf/core/vec3.h"
#include "volsurf/surface/check.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr double kPi = 3.14159265358979;

struct Ball {
  Vec3 centre;
  double radius;
};

/// 100 on the surfaces of the balls, falling by 1 per mm outwards.
Volume balls_on(const Grid &grid, const std::vector<Ball> &balls)
{
  Volume volume{grid, {}};
  for_each_sample(grid.size, [&](const Index3 &p, SampleId) {
    const Vec3 world =
        index_to_world(grid, {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    double value = -HUGE_VAL;
    for (const Ball &ball : balls)
      value = std::max(value, 100 + ball.radius - length(minus(world, ball.centre)));
    volume.samples.push_back(static_cast<float>(value));
  });
  return volume;
}

Grid cube(std::int64_t size)
{
  Grid grid;
  grid.size = {size, size, size};
  return grid;
}

/// Two bars that touch along an edge only, at the level 0.5.
Volume touching_bars()
{
  Volume volume{cube(12), std::vector<float>(12 * 12 * 12)};
  for_each_sample(volume.grid.size, [&](const Index3 &p, SampleId id) {
    const bool low = p[0] >= 3 && p[0] < 6 && p[1] >= 3 && p[1] < 6;
    const bool high = p[0] >= 6 && p[0] < 9 && p[1] >= 6 && p[1] < 9;
    volume.samples[static_cast<std::size_t>(id)] = (low || high) && p[2] >= 2 && p[2] < 10 ? 1 : 0;
  });
  return volume;
}

} // namespace

RC_GTEST_PROP(CgalMesher, FindsABallInItsPlaceOnEveryGrid, ())
{
  Dice dice(*random_seed());
  Grid grid = any_grid(dice);
  Vec3 middle{};
  for (int axis = 0; axis < 3; ++axis) {
    grid.spacing_mm[axis] = 0.75 + grid.spacing_mm[axis] / 6;
    grid.size[axis] = static_cast<std::int64_t>(25 / grid.spacing_mm[axis]);
    middle[axis] = static_cast<double>(grid.size[axis] - 1) / 2;
  }
  const Ball ball{index_to_world(grid, middle), 9};
  const Mesh mesh = cgal_surface(balls_on(grid, {ball}), 100);
  const MeshCheck check = check_mesh(mesh);
  RC_ASSERT(check.watertight);
  RC_ASSERT(check.shells == 1);
  RC_ASSERT(check.genus == 0);
  RC_ASSERT(std::abs(check.volume_mm3 / (4.0 / 3.0 * kPi * 9 * 9 * 9) - 1) < 0.02);
  for (const Point &p : mesh.points)
    RC_ASSERT(std::abs(length(minus(to_vec3(p), ball.centre)) - ball.radius) < 0.1 * smallest_spacing_mm(grid));
}

TEST(CgalMesher, FindsPartsThatAreApart)
{
  const MeshCheck check = check_mesh(cgal_surface(balls_on(cube(48), {{{14, 14, 14}, 9}, {{36, 37, 36}, 4}}), 100));
  EXPECT_TRUE(check.watertight);
  EXPECT_EQ(check.shells, 2);
}

TEST(CgalMesher, ClosesWhatTheBorderCuts)
{
  const Mesh mesh = cgal_surface(balls_on(cube(24), {{{0, 12, 12}, 8}}), 100);
  const MeshCheck check = check_mesh(mesh);
  EXPECT_TRUE(check.watertight);
  EXPECT_NEAR(check.volume_mm3 / (2.0 / 3.0 * kPi * 8 * 8 * 8), 1, 0.03);
  for (const Point &p : mesh.points)
    EXPECT_GT(p[0], -0.01);
}

TEST(CgalMesher, HasTrianglesWithoutSmallAngles)
{
  const Mesh mesh = cgal_surface(balls_on(cube(30), {{{14.3, 14.6, 14.1}, 9}}), 100);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = minus(corner(mesh, t, (i + 1) % 3), corner(mesh, t, i));
      const Vec3 b = minus(corner(mesh, t, (i + 2) % 3), corner(mesh, t, i));
      EXPECT_LT(dot(a, b) / (length(a) * length(b)), std::cos(29.9 * kPi / 180));
    }
}

TEST(CgalMesher, IsEmptyBeyondTheRangeOfTheSamples)
{
  const Volume volume = balls_on(cube(20), {{{10, 10, 10}, 5}});
  for (const double iso : {-1.0, 200.0})
    EXPECT_TRUE(cgal_surface(volume, iso).triangles.empty()) << iso;
}

TEST(CgalMesher, EndsWhereTheSurfaceTouchesItself)
{
  const Mesh mesh = cgal_surface(touching_bars(), 0.5);
  EXPECT_GT(mesh.triangles.size(), 500U);
  EXPECT_EQ(check_mesh(mesh).open_edges, 0);
}

TEST(CgalMesher, MakesTheSameMeshInEachRun)
{
  const Volume volume = balls_on(cube(30), {{{14.3, 14.6, 14.1}, 9}});
  const Mesh first = cgal_surface(volume, 100);
  const std::vector<std::vector<double>> moved_heap(1000, std::vector<double>(77));
  const Mesh again = cgal_surface(volume, 100);
  EXPECT_EQ(again.points, first.points);
  EXPECT_EQ(again.triangles, first.triangles);
}

TEST(CgalMesher, StopsWhenAskedToAndBeforeItsMemoryIsUsedUp)
{
  const Volume volume = balls_on(cube(30), {{{14.3, 14.6, 14.1}, 9}});
  int calls = 0;
  const Progress stop_later = [&](std::string_view, double) { return ++calls < 3; };
  CgalMesherOptions fine;
  fine.facet_radius = 0.25;
  EXPECT_THROW(cgal_surface(volume, 100, fine, stop_later), Cancelled);
  fine.most_memory_bytes = 1000000;
  EXPECT_THROW(cgal_surface(volume, 100, fine), InputError);
}
