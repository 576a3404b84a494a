#include "volsurf/surface/refine.h"

#include "volsurf/core/vec3.h"

#include <algorithm>
#include <limits>

namespace volsurf {

namespace {

using Edge = std::array<PointId, 2>; // ascending

Edge edge_between(PointId a, PointId b)
{
  return {std::min(a, b), std::max(a, b)};
}

double length_between(const Mesh &mesh, PointId a, PointId b)
{
  return length(minus(to_vec3(mesh.points[a]), to_vec3(mesh.points[b])));
}

/// Ascending, each once.
std::vector<Edge> find_long_edges(const Mesh &mesh, double longest_mm)
{
  std::vector<Edge> edges;
  for (const Triangle &t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (const Edge edge = edge_between(t[i], t[(i + 1) % 3]); length_between(mesh, edge[0], edge[1]) > longest_mm)
        edges.push_back(edge);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

Point middle_of(const Point &a, const Point &b)
{
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// Cuts triangles at the middles of their long edges.
class Cutter {
public:
  Cutter(const Mesh &mesh, const std::vector<Edge> &edges, std::size_t first_middle)
      : mesh_(mesh), edges_(edges), first_middle_(first_middle)
  {
  }

  /// The parts of a triangle: one, if it has no long edge.
  std::vector<Triangle> parts_of(const Triangle &triangle) const
  {
    // Turned so that the edge from the first to the second corner is long, and the one from the third to the first is
    // so only if all are.
    Triangle t = triangle;
    for (int turn = 0; turn < 3 && !(is_long(t[0], t[1]) && (!is_long(t[2], t[0]) || is_long(t[1], t[2]))); ++turn)
      t = {t[1], t[2], t[0]};
    if (!is_long(t[0], t[1]))
      return {triangle};
    const PointId ab = middle(t[0], t[1]);
    if (!is_long(t[1], t[2]))
      return {{t[0], ab, t[2]}, {ab, t[1], t[2]}};
    const PointId bc = middle(t[1], t[2]);
    if (is_long(t[2], t[0])) {
      const PointId ca = middle(t[2], t[0]);
      return {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}};
    }
    if (length_between(mesh_, t[0], bc) < length_between(mesh_, ab, t[2]))
      return {{ab, t[1], bc}, {t[0], ab, bc}, {t[0], bc, t[2]}};
    return {{ab, t[1], bc}, {t[0], ab, t[2]}, {ab, bc, t[2]}};
  }

private:
  std::vector<Edge>::const_iterator find(PointId a, PointId b) const
  {
    return std::lower_bound(edges_.begin(), edges_.end(), edge_between(a, b));
  }

  bool is_long(PointId a, PointId b) const
  {
    const auto place = find(a, b);
    return place != edges_.end() && *place == edge_between(a, b);
  }

  PointId middle(PointId a, PointId b) const
  {
    return static_cast<PointId>(first_middle_ + static_cast<std::size_t>(find(a, b) - edges_.begin()));
  }

  const Mesh &mesh_;
  const std::vector<Edge> &edges_;
  std::size_t first_middle_;
};

/// Each triangle's value for all of its parts, where there are any.
template <typename T> void repeat(std::vector<T> &values, const std::vector<std::size_t> &whole)
{
  if (values.empty())
    return;
  std::vector<T> of_parts(whole.size());
  std::transform(whole.begin(), whole.end(), of_parts.begin(), [&](std::size_t t) { return values[t]; });
  values = std::move(of_parts);
}

void halve(Mesh &mesh, const std::vector<Edge> &edges)
{
  const std::size_t first_middle = mesh.points.size();
  for (const auto &[a, b] : edges)
    mesh.points.push_back(middle_of(mesh.points[a], mesh.points[b]));
  const Cutter cutter(mesh, edges, first_middle);
  std::vector<Triangle> triangles;
  std::vector<std::size_t> whole; // of each part
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const Triangle &part : cutter.parts_of(mesh.triangles[t])) {
      triangles.push_back(part);
      whole.push_back(t);
    }
  mesh.triangles = std::move(triangles);
  repeat(mesh.region_a, whole);
  repeat(mesh.region_b, whole);
  repeat(mesh.persistence, whole);
  repeat(mesh.component, whole);
  repeat(mesh.cap, whole);
}

} // namespace

void halve_long_edges(Mesh &mesh, double longest_mm)
{
  for (int halving = 0; halving < kMostHalvings; ++halving) {
    const std::vector<Edge> edges = find_long_edges(mesh, longest_mm);
    if (edges.empty() || mesh.points.size() + edges.size() > std::numeric_limits<PointId>::max())
      return;
    halve(mesh, edges);
  }
}

} // namespace volsurf
