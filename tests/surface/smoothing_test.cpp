#include "volsurf/surface/smoothing.h"

#include "support/grids.h"
#include "support/label_volumes.h"

#include "volsurf/core/error.h"
#include "volsurf/surface/check.h"

#include <gtest/gtest.h>
#include <vtkSMPTools.h>

#include <cmath>
#include <map>
#include <set>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr double kRadius = 8;

double distance_to(const Vec3 &p, const Vec3 &centre)
{
  return std::hypot(p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]);
}

Vec3 middle_of_cell(const Index3 &cell)
{
  return {static_cast<double>(cell[0]) + 0.5, static_cast<double>(cell[1]) + 0.5, static_cast<double>(cell[2]) + 0.5};
}

/// The cells whose centres lie within kRadius of a point, as basin 1 of 0 and 1.
LabelledCells sphere_of_cells(const Vec3 &centre, double radius = kRadius)
{
  return label_cells({24, 24, 24}, 2,
                     [&](const Index3 &p) { return distance_to(middle_of_cell(p), centre) < radius ? 1U : 0U; });
}

/// A sphere cut in two by a plane through x = 12.
LabelledCells halved_sphere()
{
  return label_cells({24, 24, 24}, 3, [&](const Index3 &p) {
    if (distance_to(middle_of_cell(p), {12, 12, 12}) >= kRadius)
      return 0U;
    return p[0] < 12 ? 1U : 2U;
  });
}

double mean_distance_to_sphere(const Mesh &mesh, const Vec3 &centre)
{
  double sum = 0;
  for (const Point &p : mesh.points)
    sum += std::abs(distance_to({p[0], p[1], p[2]}, centre) - kRadius);
  return sum / static_cast<double>(mesh.points.size());
}

/// The points on edges of three or more triangles.
std::set<PointId> junction_points(const Mesh &mesh)
{
  std::map<std::array<PointId, 2>, int> triangles_at;
  for (const Triangle &t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++triangles_at[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
  std::set<PointId> points;
  for (const auto &[edge, count] : triangles_at)
    if (count > 2)
      points.insert(edge.begin(), edge.end());
  return points;
}

/// The border planes (2 * axis, and one more for the upper one) that a point lies in, in index space.
std::set<int> planes_of(const Vec3 &index, const Grid &grid)
{
  std::set<int> planes;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(index[axis]) < 1e-3)
      planes.insert(2 * axis);
    if (std::abs(index[axis] - static_cast<double>(grid.size[axis] - 1)) < 1e-3)
      planes.insert(2 * axis + 1);
  }
  return planes;
}

void expect_caps_in_planes(const Mesh &before, const Mesh &after, const Grid &grid)
{
  for (std::size_t t = 0; t < before.triangles.size(); ++t) {
    if (before.cap[t] == 0)
      continue;
    for (const PointId point : before.triangles[t]) {
      const Point &from = before.points[point];
      const Point &to = after.points[point];
      const Vec3 index = world_to_index(grid, {to[0], to[1], to[2]});
      for (const int plane : planes_of(world_to_index(grid, {from[0], from[1], from[2]}), grid)) {
        const auto expected = static_cast<double>(plane % 2 == 0 ? 0 : grid.size[plane / 2] - 1);
        EXPECT_NEAR(index[plane / 2], expected, 1e-4);
      }
    }
  }
}

} // namespace

TEST(SmoothMesh, StrengthZeroLeavesEveryByte)
{
  const LabelledCells labels = sphere_of_cells({12, 12, 12});
  Mesh mesh = mesh_of(labels, grid_of(labels.cells.size), hull_sides(labels), true);
  const Mesh before = mesh;
  EXPECT_EQ(smooth_mesh(mesh, grid_of(labels.cells.size), {0, {}, {}}).iterations, 0);
  EXPECT_EQ(mesh.points, before.points);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(SmoothMesh, SphereKeepsItsVolumeAndLosesItsStairs)
{
  const Vec3 centre{12.2, 11.9, 12.4};
  const LabelledCells labels = sphere_of_cells(centre);
  const Mesh before = mesh_of(labels, grid_of(labels.cells.size), hull_sides(labels), true);
  for (const double strength : {0.1, 0.3, 0.5, 1.0}) {
    Mesh mesh = before;
    const SmoothingResult result = smooth_mesh(mesh, grid_of(labels.cells.size), {strength, {}, {}});
    EXPECT_LT(std::abs(result.volume_drift), 0.05) << strength;
    EXPECT_NEAR(result.volume_drift, signed_volume_mm3(mesh) / signed_volume_mm3(before) - 1, 1e-12);
    EXPECT_LT(mean_distance_to_sphere(mesh, centre), 0.6 * mean_distance_to_sphere(before, centre)) << strength;
    EXPECT_TRUE(check_mesh(mesh).watertight);
  }
}

TEST(SmoothMesh, BallOfFourVoxelsKeepsItsVolumeAtTheDefault)
{
  const LabelledCells labels = sphere_of_cells({12.2, 11.9, 12.4}, 4);
  Mesh mesh = mesh_of(labels, grid_of(labels.cells.size), hull_sides(labels), true);
  EXPECT_LT(std::abs(smooth_mesh(mesh, grid_of(labels.cells.size), {}).volume_drift), 0.05);
}

TEST(SmoothMesh, CapsStayInTheirBorderPlanes)
{
  Dice dice(7);
  for (int i = 0; i < 5; ++i) {
    const LabelledCells labels = sphere_of_cells({3, 12, 22});
    Grid grid = i == 0 ? Grid{} : any_grid(dice);
    grid.size = grid_of(labels.cells.size).size;
    grid.origin_mm = {1, 2, 3};
    const Mesh before = mesh_of(labels, grid, hull_sides(labels), true);
    ASSERT_GT(std::count(before.cap.begin(), before.cap.end(), 1), 0);
    Mesh mesh = before;
    smooth_mesh(mesh, grid, {});
    expect_caps_in_planes(before, mesh, grid);
  }
}

// The two halves pull the points of the curve where they meet to both sides; the curve itself lies in a plane.
TEST(SmoothMesh, JunctionPointsMoveAlongTheirCurveOnly)
{
  const LabelledCells labels = halved_sphere();
  Mesh mesh = mesh_of(labels, grid_of(labels.cells.size), all_sides(labels), false);
  const Mesh before = mesh;
  const auto junction = junction_points(mesh);
  ASSERT_GT(junction.size(), 20U);
  smooth_mesh(mesh, grid_of(labels.cells.size), {});
  std::size_t moved = 0;
  double roughness_before = 0;
  double roughness = 0;
  for (const PointId point : junction) {
    const Point &p = mesh.points[point];
    const Point &q = before.points[point];
    EXPECT_NEAR(p[0], 12, 1e-5);
    moved += p != q ? 1 : 0;
    roughness_before += std::abs(distance_to({q[0], q[1], q[2]}, {12, 12, 12}) - kRadius);
    roughness += std::abs(distance_to({p[0], p[1], p[2]}, {12, 12, 12}) - kRadius);
  }
  EXPECT_GT(moved, junction.size() / 2);
  EXPECT_LT(roughness, 0.7 * roughness_before);
}

// Four boxes round a line: at its ends, five and more edges of three faces meet.
TEST(SmoothMesh, EndsOfJunctionCurvesStay)
{
  const LabelledCells labels = label_cells({8, 8, 8}, 5, [](const Index3 &p) {
    const bool inside = p[0] % 7 != 0 && p[1] % 7 != 0 && p[2] % 7 != 0;
    return inside ? static_cast<BasinId>(1 + p[0] / 4 + 2 * (p[1] / 4)) : 0U;
  });
  Mesh mesh = mesh_of(labels, grid_of(labels.cells.size), all_sides(labels), false);
  const Mesh before = mesh;
  smooth_mesh(mesh, grid_of(labels.cells.size), {});
  int on_line = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Point &p = before.points[i];
    if (p[0] != 4 || p[1] != 4)
      continue;
    ++on_line;
    EXPECT_NEAR(mesh.points[i][0], 4, 1e-5);
    EXPECT_NEAR(mesh.points[i][1], 4, 1e-5);
    if (p[2] == 1 || p[2] == 7) {
      EXPECT_NEAR(mesh.points[i][2], p[2], 1e-5);
    }
  }
  EXPECT_EQ(on_line, 7);
}

TEST(SmoothMesh, ThreadsDoNotChangeAByte)
{
  const LabelledCells labels = halved_sphere();
  const Mesh before = mesh_of(labels, grid_of(labels.cells.size), all_sides(labels), false);
  std::vector<Mesh> meshes;
  for (const int threads : {3, 2, 1}) { // VTK's limit on TBB can only be lowered
    vtkSMPTools::Initialize(threads);
    meshes.push_back(before);
    smooth_mesh(meshes.back(), grid_of(labels.cells.size), {});
  }
  EXPECT_EQ(meshes[1].points, meshes[0].points);
  EXPECT_EQ(meshes[2].points, meshes[0].points);
}

TEST(SmoothMesh, RefusesWhatWouldShrinkOrOverflow)
{
  Mesh mesh;
  const Grid grid = grid_of({2, 2, 2});
  for (const SmoothingOptions &options :
       {SmoothingOptions{-0.1, {}, {}}, SmoothingOptions{1.1, {}, {}}, SmoothingOptions{std::nan(""), {}, {}},
        SmoothingOptions{0.5, 14, {}}, SmoothingOptions{0.5, 1001, {}}, SmoothingOptions{0.5, {}, 1e-4},
        SmoothingOptions{0.5, {}, 2.1}})
    EXPECT_THROW(smooth_mesh(mesh, grid, options), UsageError);
}

TEST(SmoothMesh, EmptyMeshStaysEmpty)
{
  Mesh mesh;
  EXPECT_EQ(smooth_mesh(mesh, grid_of({2, 2, 2}), {}).iterations, 0);
  EXPECT_TRUE(mesh.points.empty());
}
