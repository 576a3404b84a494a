#include "volsurf/surface/mesh_components.h"

#include "support/grids.h"
#include "support/label_volumes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>

using namespace volsurf;
using namespace volsurf::support;

namespace {

/// A tetrahedron with edges of this length, corners with a right angle at (x, 0, 0).
void add_tetrahedron(Mesh &mesh, float x, float length)
{
  const auto first = static_cast<PointId>(mesh.points.size());
  for (const Point &corner : {Point{x, 0, 0}, {x + length, 0, 0}, {x, length, 0}, {x, 0, length}})
    mesh.points.push_back(corner);
  for (const Triangle &t : {Triangle{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

/// A strip of `count` thin triangles.
void add_strip(Mesh &mesh, float x, PointId count)
{
  const auto first = static_cast<PointId>(mesh.points.size());
  for (PointId i = 0; i < count + 2; ++i)
    mesh.points.push_back({x + static_cast<float>(i) * 0.1F, i % 2 == 0 ? 0.0F : 0.01F, 0});
  for (PointId i = 0; i < count; ++i)
    mesh.triangles.push_back({first + i, first + i + 1, first + i + 2});
}

/// A small and a large tetrahedron, then a strip that has more triangles than both, and a point of no triangle.
Mesh three_parts()
{
  Mesh mesh;
  add_tetrahedron(mesh, 0, 1);
  add_tetrahedron(mesh, 10, 2);
  add_strip(mesh, 20, 50);
  mesh.points.push_back({1000, 0, 0});
  return mesh;
}

Components ranked(RankBy rank_by, Keep keep = KeepAll{})
{
  return find_components(three_parts(), {keep, rank_by});
}

std::vector<ComponentId> of_parts(const Components &components)
{
  return {components.of_face[0], components.of_face[4], components.of_face[8]};
}

} // namespace

TEST(MeshComponents, AreRankedByTrianglesAreaOrRadius)
{
  const Components by_faces = ranked(RankBy::faces);
  EXPECT_EQ(of_parts(by_faces), (std::vector<ComponentId>{2, 3, 1})) << "of two with as many, the first";
  EXPECT_EQ(by_faces.sizes, (std::vector<double>{50, 4, 4}));
  const Components by_area = ranked(RankBy::area);
  EXPECT_EQ(of_parts(by_area), (std::vector<ComponentId>{2, 1, 3}));
  EXPECT_NEAR(by_area.sizes[0], 4 * (1.5 + std::sqrt(3.0) / 2), 1e-6);
  const Components by_radius = ranked(RankBy::radius);
  EXPECT_EQ(of_parts(by_radius), (std::vector<ComponentId>{3, 2, 1}));
  EXPECT_NEAR(by_radius.sizes[0], 2.55, 0.01);
  EXPECT_NEAR(by_radius.sizes[1], 2 * std::sqrt(0.75 * 0.75 + 2 * 0.25 * 0.25), 1e-6);
}

TEST(MeshComponents, AreKeptWithTheirTrianglesPointsAndNumbers)
{
  const Mesh kept = keep_components(three_parts(), ranked(RankBy::area, KeepCount{2}));
  EXPECT_EQ(kept.triangles.size(), 8U);
  EXPECT_EQ(kept.points.size(), 8U);
  EXPECT_EQ(kept.component, (std::vector<ComponentId>{2, 2, 2, 2, 1, 1, 1, 1}));
  EXPECT_TRUE(kept.region_a.empty());
}

RC_GTEST_PROP(MeshComponents, AreThoseOfTheFacesWhereEveryPointIsTheirOwn, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 6, 4);
  Grid grid = any_grid(dice);
  grid.size = grid_of(labels.cells.size).size;
  const Mesh mesh = mesh_of(labels, grid, hull_sides(labels), true);
  RC_PRE(!mesh.triangles.empty());
  // Sheets that touch have points of their own, so parts of the mesh can be more, never less, than those of the faces.
  const Components components = find_components(mesh, {KeepAll{}, RankBy::faces});
  std::map<ComponentId, ComponentId> face_component;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto known = face_component.emplace(components.of_face[i], mesh.component[i]).first;
    RC_ASSERT(known->second == mesh.component[i]);
  }
  RC_ASSERT(components.count() >= std::set<ComponentId>(mesh.component.begin(), mesh.component.end()).size());
}
