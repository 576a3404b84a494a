#include "volsurf/surface/extract.h"

#include "support/grids.h"
#include "support/label_volumes.h"

#include "volsurf/core/parallel.h"
#include "volsurf/surface/check.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>

using namespace volsurf;
using namespace volsurf::support;

namespace {

Grid placed(Grid grid, const LabelledCells &labels)
{
  grid.size = grid_of(labels.cells.size).size;
  return grid;
}

std::int64_t cells_inside(const LabelledCells &labels, const Sides &sides)
{
  std::int64_t count = 0;
  for (const BasinId basin : labels.cells.basins)
    count += sides.of_basin[basin] != 0 ? 1 : 0;
  return count;
}

std::size_t used_points(const Mesh &mesh)
{
  std::set<PointId> used;
  for (const Triangle &t : mesh.triangles)
    used.insert(t.begin(), t.end());
  return used.size();
}

Vec3 centre_of(const Mesh &mesh, std::size_t triangle)
{
  Vec3 centre{};
  for (const PointId point : mesh.triangles[triangle])
    for (int axis = 0; axis < 3; ++axis)
      centre[axis] += static_cast<double>(mesh.points[point][axis]) / 3;
  return centre;
}

Vec3 normal_of(const Mesh &mesh, const Triangle &t)
{
  Vec3 u{};
  Vec3 v{};
  for (int axis = 0; axis < 3; ++axis) {
    u[axis] = static_cast<double>(mesh.points[t[1]][axis]) - static_cast<double>(mesh.points[t[0]][axis]);
    v[axis] = static_cast<double>(mesh.points[t[2]][axis]) - static_cast<double>(mesh.points[t[0]][axis]);
  }
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// The region of the cell at a position in index space, 0 outside the volume.
RegionId region_at(const LabelledCells &labels, const Vec3 &index)
{
  Index3 cell{};
  for (int axis = 0; axis < 3; ++axis) {
    cell[axis] = static_cast<std::int64_t>(std::floor(index[axis]));
    if (cell[axis] < 0 || cell[axis] >= labels.cells.size[axis])
      return 0;
  }
  return labels.region_of_basin[labels.at(cell)];
}

/// What lies behind (0) and before (1) a triangle of a grid of unit voxels, by steps along its normal.
std::array<RegionId, 2> regions_beside(const LabelledCells &labels, const Mesh &mesh, std::size_t triangle)
{
  const Vec3 centre = centre_of(mesh, triangle);
  const Vec3 normal = normal_of(mesh, mesh.triangles[triangle]);
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  std::array<RegionId, 2> regions{};
  for (std::size_t side = 0; side < 2; ++side) {
    Vec3 position = centre;
    for (int axis = 0; axis < 3; ++axis)
      position[axis] += (side == 0 ? -0.25 : 0.25) * normal[axis] / length;
    regions[side] = region_at(labels, position);
  }
  return regions;
}

void expect_sphere_like(const MeshCheck &check, std::int64_t shells, double genus)
{
  EXPECT_TRUE(check.watertight);
  EXPECT_EQ(check.shells, shells);
  EXPECT_DOUBLE_EQ(check.genus, genus);
}

template <typename IsInside> Mesh mesh_of_inside(const Index3 &cells, IsInside is_inside)
{
  const LabelledCells labels = label_cells(cells, 2, [&](const Index3 &p) { return is_inside(p) ? 1U : 0U; });
  return mesh_of(labels, grid_of(cells), hull_sides(labels), true);
}

} // namespace

RC_GTEST_PROP(ExtractMesh, ManifoldHullIsWatertightAndHoldsTheVolumeOfItsCells, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 6, 2);
  const Sides sides = hull_sides(labels);
  const std::int64_t inside = cells_inside(labels, sides);
  RC_PRE(inside > 0);
  Grid grid = placed(any_grid(dice), labels);
  grid.origin_mm = {0, 0, 0}; // the float points of a far grid would cost the digits that are compared
  const Mesh mesh = mesh_of(labels, grid, sides, true);
  const MeshCheck check = check_mesh(mesh);
  RC_ASSERT(check.open_edges == 0);
  RC_ASSERT(check.non_manifold_edges == 0);
  RC_ASSERT(check.misoriented_edges == 0);
  RC_ASSERT(check.watertight);
  RC_ASSERT(check.genus >= 0 && check.genus == std::floor(check.genus));
  const double expected = static_cast<double>(inside) * voxel_volume_mm3(grid);
  RC_ASSERT(std::abs(check.volume_mm3 - expected) <= 1e-5 * expected);
  RC_ASSERT(used_points(mesh) == mesh.points.size());
}

// A manifold has one fan of triangles at each point: their number of sides there is the number of their neighbours.
RC_GTEST_PROP(ExtractMesh, ManifoldHullHasOneFanOfTrianglesPerPoint, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 5, 2);
  const Mesh mesh = mesh_of(labels, grid_of(labels.cells.size), hull_sides(labels), true);
  std::vector<std::map<PointId, PointId>> next(mesh.points.size());
  for (const Triangle &t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      RC_ASSERT(next[t[i]].emplace(t[(i + 1) % 3], t[(i + 2) % 3]).second);
  for (const auto &fan : next) {
    std::size_t turned = 0;
    PointId at = fan.begin()->first;
    do {
      at = fan.at(at);
      ++turned;
    } while (at != fan.begin()->first);
    RC_ASSERT(turned == fan.size());
  }
}

RC_GTEST_PROP(ExtractMesh, FullSurfaceIsClosed, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 5, 4);
  const Mesh mesh = mesh_of(labels, grid_of(labels.cells.size), all_sides(labels), false);
  RC_ASSERT(check_mesh(mesh).open_edges == 0);
  RC_ASSERT(used_points(mesh) == mesh.points.size());
  RC_ASSERT(mesh.triangles.size() == 2U * find_boundary(labels.cells, all_sides(labels)).size());
}

RC_GTEST_PROP(ExtractMesh, TrianglesPointFromTheSmallerRegionToTheLargerAndNeverOutOfTheBackground, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 5, 4);
  const Mesh mesh = mesh_of(labels, grid_of(labels.cells.size), all_sides(labels), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [behind, before] = regions_beside(labels, mesh, t);
    RC_ASSERT(mesh.region_a[t] == behind);
    RC_ASSERT(mesh.region_b[t] == (before == 0 ? 1 : before));
    RC_ASSERT(mesh.region_a[t] > mesh.region_b[t]); // larger ids are smaller regions, 1 is the background
    RC_ASSERT((mesh.cap[t] == 1) == (before == 0));
  }
}

RC_GTEST_PROP(ExtractMesh, PersistenceIsTheSaliencyOfTheTwoBasins, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 5, 4);
  const Mesh mesh = mesh_of(labels, grid_of(labels.cells.size), all_sides(labels), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    RC_ASSERT(mesh.persistence[t] == static_cast<float>(mesh.region_a[t] - 1) + 0.5F);
}

RC_GTEST_PROP(ExtractMesh, HullPointsOutOfItsInsideInMirroredAndObliqueGridsToo, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 4, 3);
  const Grid grid = placed(any_grid(dice), labels);
  const Mesh mesh = mesh_of(labels, grid, hull_sides(labels), true);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 centre = centre_of(mesh, t);
    const Vec3 normal = normal_of(mesh, mesh.triangles[t]);
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    Vec3 behind = centre;
    for (int axis = 0; axis < 3; ++axis)
      behind[axis] -= 0.25 * smallest_spacing_mm(grid) * normal[axis] / length;
    RC_ASSERT(region_at(labels, world_to_index(grid, behind)) == mesh.region_a[t]);
    RC_ASSERT(mesh.region_a[t] > 1U);
  }
}

RC_GTEST_PROP(ExtractMesh, ThreadsDoNotChangeAByte, ())
{
  Dice dice(*random_seed());
  LabelledCells labels =
      label_cells({4, 3, 40}, 3, [&](const Index3 &) { return static_cast<BasinId>(dice.between(0, 2)); });
  const bool manifold = dice.one_in(2);
  const Sides sides = manifold ? hull_sides(labels) : all_sides(labels);
  std::vector<Mesh> meshes;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    meshes.push_back(mesh_of(labels, grid_of(labels.cells.size), sides, manifold));
  }
  for (const Mesh &mesh : meshes) {
    RC_ASSERT(mesh.points == meshes.front().points);
    RC_ASSERT(mesh.triangles == meshes.front().triangles);
    RC_ASSERT(mesh.region_a == meshes.front().region_a);
    RC_ASSERT(mesh.component == meshes.front().component);
  }
}

TEST(ExtractMesh, BoxIsASphere)
{
  expect_sphere_like(
      check_mesh(mesh_of_inside({6, 6, 6}, [](const Index3 &p) { return p[0] > 1 && p[1] > 2 && p[2] < 3; })), 1, 0);
}

TEST(ExtractMesh, RingOfCellsIsATorus)
{
  const auto in_ring = [](const Index3 &p) {
    return p[2] == 1 && !(p[0] == 2 && p[1] == 2) && p[0] % 4 != 0 && p[1] % 4 != 0;
  };
  expect_sphere_like(check_mesh(mesh_of_inside({5, 5, 3}, in_ring)), 1, 1);
}

TEST(ExtractMesh, TwoBoxesAreTwoSpheres)
{
  expect_sphere_like(check_mesh(mesh_of_inside({7, 3, 3}, [](const Index3 &p) { return p[0] == 1 || p[0] >= 4; })), 2,
                     0);
}

TEST(ExtractMesh, HollowBoxHasACavity)
{
  const Mesh mesh = mesh_of_inside({5, 5, 5}, [](const Index3 &p) {
    return p[0] % 4 != 0 && p[1] % 4 != 0 && p[2] % 4 != 0 && p != Index3{2, 2, 2};
  });
  expect_sphere_like(check_mesh(mesh), 2, 0);
  EXPECT_DOUBLE_EQ(check_mesh(mesh).volume_mm3, 26);
}

// Cells that touch along an edge or at a corner are taken apart.
TEST(ExtractMesh, CheckerboardFallsApartIntoItsCells)
{
  const Mesh mesh = mesh_of_inside({4, 4, 4}, [](const Index3 &p) { return (p[0] + p[1] + p[2]) % 2 == 0; });
  expect_sphere_like(check_mesh(mesh), 32, 0);
  EXPECT_DOUBLE_EQ(check_mesh(mesh).volume_mm3, 32);
}

TEST(ExtractMesh, PinchedRingIsClosedByItsSharedEdge)
{
  // A ring whose two ends touch along one edge: the edge must not have four triangles.
  const auto inside = [](const Index3 &p) {
    static const std::set<Index3> cells{{1, 1, 1}, {1, 2, 1}, {1, 3, 1}, {2, 3, 1}, {3, 3, 1}, {3, 2, 1}, {2, 1, 1}};
    return cells.count(p) > 0;
  };
  const MeshCheck check = check_mesh(mesh_of_inside({5, 5, 3}, inside));
  expect_sphere_like(check, 1, 0);
  EXPECT_DOUBLE_EQ(check.volume_mm3, 7);
}
