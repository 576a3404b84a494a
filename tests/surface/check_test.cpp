#include "volsurf/surface/check.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace volsurf;

namespace {

Mesh mesh_of(std::vector<Point> points, std::vector<Triangle> triangles)
{
  Mesh mesh;
  mesh.points = std::move(points);
  mesh.triangles = std::move(triangles);
  return mesh;
}

Mesh tetrahedron()
{
  return mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

/// A strip of triangles, its ends joined with a half turn.
Mesh moebius_strip()
{
  constexpr PointId kPoints = 7;
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  for (PointId i = 0; i < kPoints; ++i) {
    points.push_back({static_cast<float>(i), static_cast<float>(i % 3), static_cast<float>(i * i)});
    triangles.push_back({i, (i + 1) % kPoints, (i + 2) % kPoints});
    if (i % 2 == 1)
      std::swap(triangles.back()[0], triangles.back()[1]);
  }
  return mesh_of(std::move(points), std::move(triangles));
}

} // namespace

TEST(CheckMesh, TetrahedronIsASphere)
{
  const MeshCheck check = check_mesh(tetrahedron());
  EXPECT_TRUE(check.watertight);
  EXPECT_EQ(check.points, 4);
  EXPECT_EQ(check.triangles, 4);
  EXPECT_EQ(check.shells, 1);
  EXPECT_EQ(check.euler_characteristic, 2);
  EXPECT_DOUBLE_EQ(check.genus, 0);
  EXPECT_NEAR(check.volume_mm3, 1.0 / 6, 1e-12);
  EXPECT_NEAR(check.area_mm2, 1.5 + std::sqrt(3.0) / 2, 1e-6);
  EXPECT_EQ(check.bounds_low_mm, (Vec3{0, 0, 0}));
  EXPECT_EQ(check.bounds_high_mm, (Vec3{1, 1, 1}));
}

TEST(CheckMesh, VolumeIsNegativeInsideOutAndTheSameFarAway)
{
  Mesh mesh = tetrahedron();
  for (Triangle &t : mesh.triangles)
    std::swap(t[0], t[1]);
  for (Point &point : mesh.points)
    point[0] += 1024;
  EXPECT_TRUE(check_mesh(mesh).watertight);
  EXPECT_NEAR(signed_volume_mm3(mesh), -1.0 / 6, 1e-12);
}

TEST(CheckMesh, MissingTriangleLeavesThreeOpenEdges)
{
  Mesh mesh = tetrahedron();
  mesh.triangles.pop_back();
  const MeshCheck check = check_mesh(mesh);
  EXPECT_EQ(check.open_edges, 3);
  EXPECT_FALSE(check.watertight);
  EXPECT_DOUBLE_EQ(check.genus, 0);
}

TEST(CheckMesh, TurnedTriangleHasThreeMisorientedEdges)
{
  Mesh mesh = tetrahedron();
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  const MeshCheck check = check_mesh(mesh);
  EXPECT_EQ(check.misoriented_edges, 3);
  EXPECT_EQ(check.open_edges, 0);
  EXPECT_FALSE(check.watertight);
}

TEST(CheckMesh, MoebiusStripCannotBeOriented)
{
  const MeshCheck check = check_mesh(moebius_strip());
  EXPECT_GT(check.misoriented_edges, 0);
  EXPECT_EQ(check.euler_characteristic, 0);
  EXPECT_EQ(check.open_edges, 7);
}

TEST(CheckMesh, EdgeOfThreeTrianglesIsNotManifold)
{
  Mesh mesh = tetrahedron();
  mesh.points.push_back({1, 1, 1});
  mesh.triangles.push_back({1, 2, 4});
  const MeshCheck check = check_mesh(mesh);
  EXPECT_EQ(check.non_manifold_edges, 1);
  EXPECT_EQ(check.open_edges, 2);
  EXPECT_FALSE(check.watertight);
}

TEST(CheckMesh, TwoTetrahedraAreTwoShells)
{
  Mesh mesh = tetrahedron();
  for (const Point &point : tetrahedron().points)
    mesh.points.push_back({point[0] + 5, point[1], point[2]});
  for (const Triangle &t : tetrahedron().triangles)
    mesh.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  const MeshCheck check = check_mesh(mesh);
  EXPECT_TRUE(check.watertight);
  EXPECT_EQ(check.shells, 2);
  EXPECT_EQ(check.euler_characteristic, 4);
  EXPECT_DOUBLE_EQ(check.genus, 0);
}

TEST(CheckMesh, EmptyMeshIsNeverWatertight)
{
  const MeshCheck check = check_mesh({});
  EXPECT_FALSE(check.watertight);
  EXPECT_EQ(check.triangles, 0);
  EXPECT_DOUBLE_EQ(check.volume_mm3, 0);
}

TEST(CheckMesh, SumIsTheCheckOfBothMeshesInOne)
{
  const Mesh closed = tetrahedron();
  Mesh open = tetrahedron();
  open.triangles.pop_back();
  std::swap(open.triangles[0][0], open.triangles[0][1]);
  for (const Mesh &other : {closed, open, Mesh{}}) {
    Mesh both = closed;
    for (const Point &point : other.points)
      both.points.push_back({point[0] - 5, point[1], point[2] + 3});
    const Mesh moved = mesh_of({both.points.begin() + 4, both.points.end()}, other.triangles);
    for (const Triangle &t : other.triangles)
      both.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
    const MeshCheck sum = check_mesh(closed) + check_mesh(moved);
    const MeshCheck expected = check_mesh(both);
    EXPECT_EQ(sum.points, expected.points);
    EXPECT_EQ(sum.triangles, expected.triangles);
    EXPECT_EQ(sum.shells, expected.shells);
    EXPECT_EQ(sum.open_edges, expected.open_edges);
    EXPECT_EQ(sum.non_manifold_edges, expected.non_manifold_edges);
    EXPECT_EQ(sum.misoriented_edges, expected.misoriented_edges);
    EXPECT_EQ(sum.euler_characteristic, expected.euler_characteristic);
    EXPECT_EQ(sum.watertight, expected.watertight);
    EXPECT_DOUBLE_EQ(sum.genus, expected.genus);
    EXPECT_NEAR(sum.area_mm2, expected.area_mm2, 1e-6);
    EXPECT_EQ(sum.bounds_low_mm, expected.bounds_low_mm);
    EXPECT_EQ(sum.bounds_high_mm, expected.bounds_high_mm);
    if (expected.watertight) {
      EXPECT_NEAR(sum.volume_mm3, expected.volume_mm3, 1e-6);
    }
  }
}
