// The nearest place and its side, beside VTK's locator and beside bodies that are intersections of half-spaces.
#include "support/solids.h"
#include "volsurf/compare/nearest_surface.h"
#include "volsurf/compare/tidy_mesh.h"
#include "volsurf/compare/triangle_tree.h"
#include "volsurf/core/vec3.h"
#include "volsurf/interop/vtk_mesh.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <vtkCellLocator.h>
#include <vtkNew.h>

namespace volsurf::test {
namespace {

/// On a coarse lattice, so that ties, flat angles and touching triangles are common.
rc::Gen<Point> some_point()
{
  return rc::gen::map(rc::gen::container<std::array<int, 3>>(rc::gen::inRange(-8, 9)), [](const std::array<int, 3> &p) {
    return Point{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  });
}

Mesh some_triangles()
{
  Mesh mesh;
  const int count = *rc::gen::inRange(1, 40);
  for (int i = 0; i < 3 * count; ++i)
    mesh.points.push_back(*some_point());
  for (PointId i = 0; i < static_cast<PointId>(count); ++i)
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  drop_unused(mesh);
  RC_PRE(!mesh.triangles.empty());
  return mesh;
}

RC_GTEST_PROP(TriangleTree, finds_the_distance_that_vtk_finds, ())
{
  const Mesh mesh = some_triangles();
  const vtkSmartPointer<vtkPolyData> data = to_poly_data(mesh);
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(data);
  locator->BuildLocator();
  const TriangleTree tree(mesh);
  for (int i = 0; i < 10; ++i) {
    const Vec3 point = plus(to_vec3(*some_point()), 0.37, to_vec3(*some_point()));
    Vec3 place{};
    vtkIdType cell = 0;
    int part = 0;
    double squared = 0;
    locator->FindClosestPoint(point.data(), place.data(), cell, part, squared);
    const NearestPlace nearest = tree.nearest(point, static_cast<std::size_t>(i) % mesh.triangles.size());
    RC_ASSERT(std::abs(std::sqrt(nearest.squared) - std::sqrt(squared)) < 1e-5);
    RC_ASSERT(std::abs(length(nearest.offset) - std::sqrt(nearest.squared)) < 1e-9);
  }
}

RC_GTEST_PROP(NearestSurface, tells_inside_from_outside_of_any_tetrahedron, ())
{
  Mesh mesh;
  for (int i = 0; i < 4; ++i)
    mesh.points.push_back(*some_point());
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const auto height = [&](const Vec3 &p, std::size_t t) {
    return dot(doubled_area_normal(mesh, t), minus(p, corner(mesh, t, 0)));
  };
  const double volume = height(to_vec3(mesh.points[3]), 0);
  RC_PRE(volume != 0);
  if (volume > 0)
    for (Triangle &t : mesh.triangles)
      std::swap(t[1], t[2]);
  std::vector<Vec3> points;
  for (int i = 0; i < 20; ++i)
    points.push_back(plus(to_vec3(*some_point()), 0.37, to_vec3(*some_point())));
  const std::vector<double> distances = NearestSurface(mesh).signed_distances(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool outside = false;
    for (std::size_t t = 0; t < 4; ++t)
      outside = outside || height(points[i], t) > 0;
    RC_ASSERT(std::abs(distances[i]) < 1e-9 || (distances[i] > 0) == outside);
  }
}

/// Where two cubes touch along an edge, four triangles meet at it, whose normals cancel.
TEST(NearestSurface, TellsTheSideWhereASurfaceTouchesItself)
{
  Mesh mesh = joined(box_mesh({-1, -1, -1}, {0, 0, 1}), box_mesh({0, 0, -1}, {1, 1, 1}));
  weld_points(mesh);
  EXPECT_EQ(mesh.points.size(), 14U);
  EXPECT_EQ(count_unbalanced_edges(mesh), 0);
  const NearestSurface surface(mesh);
  for (const double x : {-0.2, -0.1, 0.1, 0.2})
    for (const double y : {-0.3, -0.15, 0.15, 0.3})
      for (const double z : {-0.5, 0.25}) {
        const double distance = surface.signed_distances({{x, y, z}})[0];
        EXPECT_NEAR(distance, x * y > 0 ? -std::min(std::abs(x), std::abs(y)) : std::min(std::abs(x), std::abs(y)),
                    1e-6)
            << x << ' ' << y << ' ' << z;
      }
}

TEST(TidyMesh, DropsWhatHasNoAreaAndKeepsTheArraysInStep)
{
  Mesh mesh;
  mesh.points = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  mesh.triangles = {{1, 2, 4}, {1, 2, 3}, {1, 1, 2}, {2, 3, 4}};
  mesh.persistence = {1, 2, 3, 4};
  drop_unused(mesh);
  EXPECT_EQ(mesh.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 2, 3}}));
  EXPECT_EQ(mesh.persistence, (std::vector<float>{2, 4}));
}

TEST(TidyMesh, CountsTheEdgesThatKeepASurfaceFromEnclosing)
{
  Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(count_unbalanced_edges(mesh), 0);
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  EXPECT_EQ(count_unbalanced_edges(mesh), 3) << "a triangle the wrong way round";
  mesh.triangles.erase(mesh.triangles.begin());
  EXPECT_EQ(count_unbalanced_edges(mesh), 3) << "a hole";
  Mesh soup = cut_in_four(box_mesh({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(count_unbalanced_edges(soup), 12 * 6) << "no triangle's outline is shared";
  weld_points(soup);
  EXPECT_EQ(count_unbalanced_edges(soup), 0);
  EXPECT_EQ(soup.points.size(), 26U);
}

} // namespace
} // namespace volsurf::test
