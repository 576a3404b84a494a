#include "volsurf/compare/tidy_mesh.h"

#include "volsurf/compare/edges.h"
#include "volsurf/core/vec3.h"

#include <numeric>

namespace volsurf {

namespace {

/// Keeps the values whose triangle is kept; an array that a mesh does not have is empty.
template <typename Value> void keep_values(std::vector<Value> &values, const std::vector<std::size_t> &kept)
{
  if (values.empty())
    return;
  for (std::size_t i = 0; i < kept.size(); ++i)
    values[i] = values[kept[i]];
  values.resize(kept.size());
}

void keep_triangles(Mesh &mesh, const std::vector<std::size_t> &kept)
{
  keep_values(mesh.triangles, kept);
  keep_values(mesh.region_a, kept);
  keep_values(mesh.region_b, kept);
  keep_values(mesh.persistence, kept);
  keep_values(mesh.component, kept);
  keep_values(mesh.cap, kept);
}

/// Gives the points that triangles use new numbers without gaps.
void drop_unused_points(Mesh &mesh)
{
  std::vector<PointId> number(mesh.points.size(), 0);
  for (const Triangle &triangle : mesh.triangles)
    for (const PointId id : triangle)
      number[id] = 1;
  PointId count = 0;
  for (std::size_t id = 0; id < number.size(); ++id)
    if (number[id] != 0) {
      mesh.points[count] = mesh.points[id];
      number[id] = count++;
    }
  mesh.points.resize(count);
  for (Triangle &triangle : mesh.triangles)
    for (PointId &id : triangle)
      id = number[id];
}

} // namespace

std::int64_t count_unbalanced_edges(const Mesh &mesh)
{
  std::int64_t count = 0;
  for_each_edge(mesh, [&](auto first, auto last) {
    const auto ascending = std::count_if(first, last, [](const Side &side) { return side.ascending; });
    count += 2 * ascending != last - first ? 1 : 0;
  });
  return count;
}

void drop_unused(Mesh &mesh)
{
  std::vector<std::size_t> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (length(doubled_area_normal(mesh, t)) > 0)
      kept.push_back(t);
  keep_triangles(mesh, kept);
  drop_unused_points(mesh);
}

void weld_points(Mesh &mesh)
{
  std::vector<PointId> order(mesh.points.size());
  std::iota(order.begin(), order.end(), PointId{0});
  std::sort(order.begin(), order.end(), [&](PointId a, PointId b) {
    return mesh.points[a] != mesh.points[b] ? mesh.points[a] < mesh.points[b] : a < b;
  });
  std::vector<PointId> first(mesh.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && mesh.points[order[i]] == mesh.points[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  for (Triangle &triangle : mesh.triangles)
    for (PointId &id : triangle)
      id = first[id];
  drop_unused(mesh);
}

} // namespace volsurf
