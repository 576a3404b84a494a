#include "volsurf/surface/mesh_parts.h"

#include "volsurf/core/grid.h"

#include <algorithm>

namespace volsurf {

namespace {

Vec3 from_to(const Point &a, const Point &b)
{
  return {static_cast<double>(b[0]) - a[0], static_cast<double>(b[1]) - a[1], static_cast<double>(b[2]) - a[2]};
}

/// Of the tetrahedron between a triangle and a point.
double signed_volume_mm3(const Point &apex, const Mesh &mesh, const Triangle &t)
{
  const Vec3 a = from_to(apex, mesh.points[t[0]]);
  const Vec3 b = from_to(apex, mesh.points[t[1]]);
  const Vec3 c = from_to(apex, mesh.points[t[2]]);
  return determinant({a, b, c}) / 6;
}

/// Nothing of an array that the mesh does not have.
template <typename Value> std::vector<Value> values_at(const std::vector<Value> &values, const TriangleList &triangles)
{
  std::vector<Value> result;
  if (values.empty())
    return result;
  result.reserve(triangles.size());
  for (const std::size_t triangle : triangles)
    result.push_back(values[triangle]);
  return result;
}

/// The points that the triangles use, ascending, each once.
std::vector<PointId> used_points(const std::vector<Triangle> &triangles)
{
  std::vector<PointId> points;
  points.reserve(3 * triangles.size());
  for (const Triangle &t : triangles)
    points.insert(points.end(), t.begin(), t.end());
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

} // namespace

std::vector<TriangleList> triangles_by_component(const Mesh &mesh, std::size_t components)
{
  std::vector<TriangleList> triangles(components);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    triangles[mesh.component[i] - 1].push_back(i);
  return triangles;
}

std::vector<double> volumes_by_component_mm3(const Mesh &mesh, std::size_t components)
{
  std::vector<double> volumes(components);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    volumes[mesh.component[i] - 1] += signed_volume_mm3(mesh.points.front(), mesh, mesh.triangles[i]);
  return volumes;
}

Mesh take_triangles(const Mesh &mesh, const TriangleList &triangles)
{
  Mesh part;
  part.triangles = values_at(mesh.triangles, triangles);
  part.region_a = values_at(mesh.region_a, triangles);
  part.region_b = values_at(mesh.region_b, triangles);
  part.persistence = values_at(mesh.persistence, triangles);
  part.component = values_at(mesh.component, triangles);
  part.cap = values_at(mesh.cap, triangles);

  const std::vector<PointId> points = used_points(part.triangles);
  for (const PointId point : points)
    part.points.push_back(mesh.points[point]);
  for (Triangle &t : part.triangles)
    for (PointId &point : t)
      point = static_cast<PointId>(std::lower_bound(points.begin(), points.end(), point) - points.begin());
  return part;
}

} // namespace volsurf
