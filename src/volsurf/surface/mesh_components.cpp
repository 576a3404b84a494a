#include "volsurf/surface/mesh_components.h"

#include "volsurf/core/grid.h"
#include "volsurf/core/index_forest.h"
#include "volsurf/surface/mesh_parts.h"
#include "volsurf/surface/rank_components.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace volsurf {

namespace {

constexpr ComponentId kNoComponent = std::numeric_limits<ComponentId>::max();

/// Per triangle, from 0 in the order of their lowest triangles.
struct Numbering {
  std::vector<ComponentId> of_triangle;
  std::vector<std::int64_t> lowest_triangle;
};

Numbering number_components(const Mesh &mesh)
{
  IndexForest forest(static_cast<std::uint32_t>(mesh.points.size()));
  for (const Triangle &t : mesh.triangles) {
    forest.join(t[0], t[1]);
    forest.join(t[1], t[2]);
  }
  Numbering numbering;
  std::vector<ComponentId> of_root(mesh.points.size(), kNoComponent);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    ComponentId &component = of_root[forest.find(mesh.triangles[i][0])];
    if (component == kNoComponent) {
      component = static_cast<ComponentId>(numbering.lowest_triangle.size());
      numbering.lowest_triangle.push_back(static_cast<std::int64_t>(i));
    }
    numbering.of_triangle.push_back(component);
  }
  return numbering;
}

double area_mm2(const Mesh &mesh, const Triangle &t)
{
  const auto edge = [&](PointId to) {
    Vec3 way{};
    for (std::size_t i = 0; i < 3; ++i)
      way[i] = static_cast<double>(mesh.points[to][i]) - static_cast<double>(mesh.points[t[0]][i]);
    return way;
  };
  const Vec3 a = edge(t[1]);
  const Vec3 b = edge(t[2]);
  return std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]) / 2;
}

/// The component of each point; kNoComponent for points of no triangle.
std::vector<ComponentId> components_of_points(const Mesh &mesh, const Numbering &numbering)
{
  std::vector<ComponentId> of_point(mesh.points.size(), kNoComponent);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const PointId point : mesh.triangles[i])
      of_point[point] = numbering.of_triangle[i];
  return of_point;
}

std::vector<double> radii_mm(const Mesh &mesh, const Numbering &numbering)
{
  const std::vector<ComponentId> of_point = components_of_points(mesh, numbering);
  const auto for_each_point = [&](const auto &visit) {
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      if (of_point[i] != kNoComponent)
        visit(of_point[i], mesh.points[i]);
  };
  std::vector<Vec3> centroid(numbering.lowest_triangle.size());
  std::vector<double> points(centroid.size());
  for_each_point([&](ComponentId component, const Point &point) {
    for (std::size_t i = 0; i < 3; ++i)
      centroid[component][i] += static_cast<double>(point[i]);
    ++points[component];
  });
  std::vector<double> radius(centroid.size());
  for_each_point([&](ComponentId component, const Point &point) {
    Vec3 way{};
    for (std::size_t i = 0; i < 3; ++i)
      way[i] = static_cast<double>(point[i]) - centroid[component][i] / points[component];
    radius[component] = std::max(radius[component], std::hypot(way[0], way[1], way[2]));
  });
  return radius;
}

std::vector<double> sizes_of(const Mesh &mesh, const Numbering &numbering, RankBy rank_by)
{
  if (rank_by == RankBy::radius)
    return radii_mm(mesh, numbering);
  std::vector<double> sizes(numbering.lowest_triangle.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    sizes[numbering.of_triangle[i]] += rank_by == RankBy::area ? area_mm2(mesh, mesh.triangles[i]) : 1;
  return sizes;
}

} // namespace

Components find_components(const Mesh &mesh, const ComponentOptions &options)
{
  const Numbering numbering = number_components(mesh);
  return rank_components(numbering.of_triangle, sizes_of(mesh, numbering, options.rank_by), numbering.lowest_triangle,
                         options.keep);
}

Mesh keep_components(const Mesh &mesh, const Components &components)
{
  TriangleList kept;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (components.of_face[i] <= components.kept)
      kept.push_back(i);
  Mesh result = take_triangles(mesh, kept);
  for (const std::size_t triangle : kept)
    result.component.push_back(components.of_face[triangle]);
  return result;
}

} // namespace volsurf
