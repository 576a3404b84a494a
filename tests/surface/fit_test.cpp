#include "volsurf/surface/fit.h"

#include "support/label_volumes.h"
#include "support/partial_volumes.h"

#include "volsurf/core/parallel.h"
#include "volsurf/field/oversample.h"
#include "volsurf/surface/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

using namespace volsurf;
using namespace volsurf::support;

namespace {

const Index3 kSize{28, 28, 28};
const Vec3 kCentre{13.3, 13.8, 13.6};
constexpr double kRadius = 8.2;

double distance_to_ball(const Vec3 &p)
{
  return std::hypot(p[0] - kCentre[0], p[1] - kCentre[1], p[2] - kCentre[2]) - kRadius;
}

/// A plate less than two voxels thick, its faces between parts of voxels.
constexpr double kLowFace = 12.3;
constexpr double kHighFace = 14.1;

double distance_to_plate(const Vec3 &p)
{
  return std::max({std::abs(p[0] - 14) - 9, std::abs(p[1] - 14) - 9, kLowFace - p[2], p[2] - kHighFace});
}

/// The staircase of the cells whose centres are inside, around them as one thing.
template <typename Distance> Mesh staircase(Distance distance)
{
  const Index3 cells{kSize[0] - 1, kSize[1] - 1, kSize[2] - 1};
  const LabelledCells labels = label_cells(cells, 2, [&](const Index3 &p) {
    return static_cast<BasinId>(distance(Vec3{static_cast<double>(p[0]) + 0.5, static_cast<double>(p[1]) + 0.5,
                                              static_cast<double>(p[2]) + 0.5}) < 0
                                    ? 1
                                    : 0);
  });
  return mesh_of(labels, grid_of(cells), hull_sides(labels), true);
}

double ball_error(const Mesh &mesh)
{
  double squared = 0;
  for (const Point &point : mesh.points)
    squared += std::pow(distance_to_ball(to_vec3(point)), 2);
  return std::sqrt(squared / static_cast<double>(mesh.points.size()));
}

} // namespace

TEST(FitMesh, FindsTheBallThatMadeTheScan)
{
  const Volume scan = scan_of_body(kSize, distance_to_ball);
  Mesh mesh = staircase(distance_to_ball);
  const PlacementResult result = fit_mesh(mesh, scan, scan.grid, 0);
  EXPECT_EQ(result.moved, static_cast<std::int64_t>(mesh.points.size()));
  EXPECT_LT(ball_error(mesh), 0.05); // a staircase has 0.45
  EXPECT_NEAR(signed_volume_mm3(mesh), 4.0 / 3.0 * 3.14159265 * std::pow(kRadius, 3), 0.002 * 2309);
}

TEST(FitMesh, FindsADarkBodyAsWell)
{
  const Volume scan = scan_of_body(kSize, distance_to_ball, 200, 100);
  Mesh mesh = staircase(distance_to_ball);
  fit_mesh(mesh, scan, scan.grid, 0);
  EXPECT_LT(ball_error(mesh), 0.05);
}

TEST(FitMesh, PutsAWallOverALayerWhereItIs)
{
  constexpr double kLayer = 1.25; // voxels
  const auto distance_to_core = [](const Vec3 &p) { return distance_to_ball(p) + kLayer; };
  Volume scan = scan_of_body(kSize, distance_to_ball);
  const Volume core = scan_of_body(kSize, distance_to_core, 0, 80);
  std::transform(scan.samples.begin(), scan.samples.end(), core.samples.begin(), scan.samples.begin(), std::plus<>());
  Mesh mesh = staircase(distance_to_ball);
  Mesh mesh_of_several = mesh; // as the merge finds the core and what is around it
  for (std::size_t triangle = 0; triangle < mesh.region_a.size(); triangle += 2)
    mesh_of_several.region_a[triangle] += 2;
  fit_mesh(mesh, scan, scan.grid, 0);
  fit_mesh(mesh_of_several, scan, scan.grid, 0);
  EXPECT_LT(ball_error(mesh_of_several), 0.08);
  EXPECT_GT(ball_error(mesh), 0.3) << "or the scan has no layer worth its name";
}

TEST(FitMesh, IsMovedLessByImpulsesThanTheyAreWorth)
{
  Volume scan = scan_of_body(kSize, distance_to_ball);
  Dice dice(7);
  for (float &sample : scan.samples)
    if (dice.one_in(50))
      sample = dice.one_in(2) ? 100 : 200;
  Mesh mesh = staircase(distance_to_ball);
  fit_mesh(mesh, scan, scan.grid, 0);
  EXPECT_LT(ball_error(mesh), 0.135); // 0.151 where they count in full
}

TEST(FitMesh, FindsBothWallsOfAPlateThinnerThanTwoVoxels)
{
  const Volume scan = scan_of_body(kSize, distance_to_plate);
  Mesh mesh = staircase(distance_to_plate);
  fit_mesh(mesh, scan, scan.grid, 0);
  double squared = 0;
  int found = 0;
  for (const Point &p : mesh.points)
    if (std::abs(p[0] - 14) < 4 && std::abs(p[1] - 14) < 4) {
      squared += std::pow(p[2] - (p[2] < 13.2 ? kLowFace : kHighFace), 2);
      ++found;
    }
  EXPECT_GT(found, 100);
  EXPECT_LT(std::sqrt(squared / found), 0.05);
}

TEST(FitMesh, LooksOnlyAtTheScansOwnSamples)
{
  const Volume scan = scan_of_body(kSize, distance_to_ball);
  Volume fine;
  fine.grid = oversampled_grid(scan.grid, 2);
  for_each_sample(fine.grid.size, [&](const Index3 &p, SampleId) {
    const bool own = p[0] % 2 == 0 && p[1] % 2 == 0 && p[2] % 2 == 0;
    const auto sample = static_cast<std::size_t>(p[0] / 2 + kSize[0] * (p[1] / 2 + kSize[1] * (p[2] / 2)));
    fine.samples.push_back(own ? scan.samples[sample] : std::numeric_limits<float>::quiet_NaN());
  });
  Mesh mesh = staircase(distance_to_ball);
  fit_mesh(mesh, fine, scan.grid, 0);
  EXPECT_LT(ball_error(mesh), 0.08);
}

TEST(FitMesh, LeavesPointsWithTheirNeighboursWhereTheScanSaysNothing)
{
  Volume scan = scan_of_body(kSize, distance_to_ball);
  for (float &sample : scan.samples)
    sample = 7;
  const Mesh before = staircase(distance_to_ball);
  Mesh mesh = before;
  const PlacementResult result = fit_mesh(mesh, scan, scan.grid, 1);
  EXPECT_EQ(result.moved, 0);
  EXPECT_EQ(result.followed, result.points);
  EXPECT_LT(ball_error(mesh), ball_error(before)) << "fairing evens the staircase out";
}

TEST(FitMesh, KeepsCapsInTheBorderPlane)
{
  const auto cut = [](const Vec3 &p) { return distance_to_ball({p[0], p[1], p[2] + 14}); };
  const Volume scan = scan_of_body(kSize, cut);
  const Mesh before = staircase(cut);
  Mesh mesh = before;
  fit_mesh(mesh, scan, scan.grid, 0);
  std::int64_t rim = 0;
  for (std::size_t i = 0; i < before.points.size(); ++i)
    if (before.points[i][2] == 0.0F) {
      EXPECT_NEAR(mesh.points[i][2], 0, 1e-6);
      rim += mesh.points[i] != before.points[i];
    } else {
      EXPECT_NEAR(cut(to_vec3(mesh.points[i])), 0, 0.3);
    }
  EXPECT_GT(rim, 20) << "where a cap meets the wall its points move within the plane";
}

TEST(FitMesh, IsTheSameForAnyNumberOfThreads)
{
  const Volume scan = scan_of_body(kSize, distance_to_ball);
  const Mesh start = staircase(distance_to_ball);
  Mesh expected = start;
  fit_mesh(expected, scan, scan.grid, 10);
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    Mesh mesh = start;
    fit_mesh(mesh, scan, scan.grid, 10);
    EXPECT_EQ(mesh.points, expected.points) << threads;
  }
}

TEST(EnclosesOneThing, WhereAClosedMeshHasNoRegionOnBothSides)
{
  Mesh mesh = staircase(distance_to_ball);
  EXPECT_TRUE(encloses_one_thing(mesh));
  mesh.region_b[0] = mesh.region_a[1];
  EXPECT_FALSE(encloses_one_thing(mesh));
  mesh.region_b[0] = mesh.region_b[1];
  mesh.triangles.pop_back();
  mesh.region_a.pop_back();
  mesh.region_b.pop_back();
  EXPECT_FALSE(encloses_one_thing(mesh)) << "open";
}
