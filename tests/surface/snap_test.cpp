#include "volsurf/surface/snap.h"

#include "support/label_volumes.h"

#include "volsurf/core/parallel.h"
#include "volsurf/core/vec3.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr double kRadius = 9;
const Vec3 kCentre{12, 12, 12};

double radius_at(const Vec3 &p)
{
  return std::hypot(p[0] - kCentre[0], p[1] - kCentre[1], p[2] - kCentre[2]);
}

/// A ball of cells; where `cut` it loses its lower half at the border of the volume.
LabelledCells ball_of_cells(bool cut)
{
  const std::int64_t from = cut ? 12 : 0;
  return label_cells({24, 24, 24 - from}, 2, [&](const Index3 &p) {
    const Vec3 centre{static_cast<double>(p[0]) + 0.5, static_cast<double>(p[1]) + 0.5,
                      static_cast<double>(p[2] + from) + 0.5};
    return static_cast<BasinId>(radius_at(centre) < kRadius ? 1 : 0);
  });
}

/// The exact way to the sphere, straight along the direction.
std::optional<LocatedEdge> edge_of_sphere(const Vec3 &p, const Vec3 &direction, double limit)
{
  const Vec3 from{p[0] - kCentre[0], p[1] - kCentre[1], p[2] - kCentre[2]};
  const double along = from[0] * direction[0] + from[1] * direction[1] + from[2] * direction[2];
  const double under_root = along * along - radius_at(p) * radius_at(p) + kRadius * kRadius;
  if (under_root < 0)
    return std::nullopt;
  const double root = std::sqrt(under_root);
  const double way = std::abs(-along - root) < std::abs(-along + root) ? -along - root : -along + root;
  return std::abs(way) <= limit ? std::optional(LocatedEdge{way, 0}) : std::nullopt;
}

bool turned_over(const Mesh &before, const Mesh &after, std::size_t t)
{
  return dot(doubled_area_normal(before, t), doubled_area_normal(after, t)) < 0;
}

/// Ways as wild as noise can make them, the same for the same place.
std::optional<LocatedEdge> wild_edge(const Vec3 &p, const Vec3 &, double limit)
{
  const double number = std::sin(12.9898 * p[0] + 78.233 * p[1] + 37.719 * p[2]) * 43758.5453;
  const double fraction = number - std::floor(number);
  return fraction < 0.2 ? std::nullopt : std::optional(LocatedEdge{(2 * fraction - 1) * limit, 0.3 * fraction});
}

} // namespace

TEST(SnapMesh, BringsPointsToTheEdge)
{
  const LabelledCells labels = ball_of_cells(false);
  Mesh mesh = mesh_of(labels, grid_of(labels.cells.size), hull_sides(labels), true);
  const PlacementResult result = snap_mesh(mesh, grid_of(labels.cells.size), edge_of_sphere);
  EXPECT_GT(result.moved, static_cast<std::int64_t>(mesh.points.size() * 9 / 10));
  EXPECT_EQ(result.moved + result.followed, static_cast<std::int64_t>(mesh.points.size()));
  double squared = 0;
  for (const Point &point : mesh.points)
    squared += std::pow(radius_at(to_vec3(point)) - kRadius, 2);
  EXPECT_LT(std::sqrt(squared / static_cast<double>(mesh.points.size())), 0.12); // a staircase has 0.45
}

TEST(SnapMesh, KeepsCapsInTheBorderPlane)
{
  const LabelledCells labels = ball_of_cells(true);
  const Grid grid = grid_of(labels.cells.size);
  const Mesh before = mesh_of(labels, grid, hull_sides(labels), true);
  Mesh after = before;
  snap_mesh(after, grid, [](const Vec3 &p, const Vec3 &direction, double limit) {
    return edge_of_sphere({p[0], p[1], p[2] + 12}, direction, limit);
  });
  std::int64_t rim = 0;
  for (std::size_t i = 0; i < before.points.size(); ++i)
    if (before.points[i][2] == 0.0F) {
      EXPECT_NEAR(after.points[i][2], 0, 1e-6);
      rim += after.points[i] != before.points[i];
    }
  EXPECT_GT(rim, 20) << "where a cap meets the wall its points move within the plane";
}

RC_GTEST_PROP(SnapMesh, NoTriangleTurnsOverAndNoPointGoesBeyondItsLimit, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 5, 3);
  Grid grid = grid_of(labels.cells.size);
  grid.spacing_mm = {0.5, 1, 1.5};
  const Mesh before = mesh_of(labels, grid, all_sides(labels), false);
  Mesh after = before;
  const PlacementResult result = snap_mesh(after, grid, wild_edge);
  for (std::size_t t = 0; t < before.triangles.size(); ++t)
    RC_ASSERT(!turned_over(before, after, t));
  for (std::size_t i = 0; i < before.points.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      RC_ASSERT(std::abs(after.points[i][axis] - before.points[i][axis]) <= 1.5 * kSnapLimitVoxels + 1e-5);
  RC_ASSERT(result.rejected <= static_cast<std::int64_t>(before.points.size()));
}

TEST(SnapMesh, PointsWithoutAnEdgeGoWithTheirNeighbours)
{
  const LabelledCells labels = ball_of_cells(false);
  const Grid grid = grid_of(labels.cells.size);
  Mesh mesh = mesh_of(labels, grid, hull_sides(labels), true);
  const auto in_stripes = [](const Vec3 &p, const Vec3 &direction, double limit) {
    return std::fmod(p[2], 4) > 1 ? edge_of_sphere(p, direction, limit) : std::nullopt;
  };
  const PlacementResult result = snap_mesh(mesh, grid, in_stripes);
  EXPECT_GT(result.followed, 100);
  EXPECT_EQ(result.moved + result.followed, static_cast<std::int64_t>(mesh.points.size()));
  double squared = 0;
  for (const Point &point : mesh.points)
    squared += std::pow(radius_at(to_vec3(point)) - kRadius, 2);
  EXPECT_LT(std::sqrt(squared / static_cast<double>(mesh.points.size())), 0.12); // a staircase has 0.45
}

TEST(SnapMesh, IsTheSameForAnyNumberOfThreads)
{
  const LabelledCells labels = ball_of_cells(false);
  const Grid grid = grid_of(labels.cells.size);
  const Mesh start = mesh_of(labels, grid, hull_sides(labels), true);
  Mesh expected = start;
  snap_mesh(expected, grid, wild_edge);
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    Mesh mesh = start;
    snap_mesh(mesh, grid, wild_edge);
    EXPECT_EQ(mesh.points, expected.points);
  }
}
