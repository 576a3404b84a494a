#include "volsurf/surface/check.h"

#include "volsurf/core/vec3.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace volsurf {

namespace {

/// The sides of all triangles in buckets by their lower point.
class EdgeBuckets {
public:
  struct Side {
    PointId higher;
    bool ascending; ///< the triangle runs from the lower to the higher point
  };

  explicit EdgeBuckets(const Mesh &mesh) : start_(mesh.points.size() + 1), sides_(3 * mesh.triangles.size())
  {
    for (const Triangle &t : mesh.triangles)
      for (int i = 0; i < 3; ++i)
        ++start_[std::min(t[i], t[(i + 1) % 3]) + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (const Triangle &t : mesh.triangles)
      for (int i = 0; i < 3; ++i) {
        const PointId from = t[i];
        const PointId to = t[(i + 1) % 3];
        sides_[next[std::min(from, to)]++] = {std::max(from, to), from < to};
      }
  }

  /// Calls visit(number of triangles at the edge, how many of them ascend) for each edge.
  template <typename Visit> void for_each_edge(Visit visit)
  {
    for (std::size_t point = 0; point + 1 < start_.size(); ++point) {
      const auto begin = sides_.begin() + static_cast<std::ptrdiff_t>(start_[point]);
      const auto end = sides_.begin() + static_cast<std::ptrdiff_t>(start_[point + 1]);
      std::sort(begin, end, [](const Side &a, const Side &b) { return a.higher < b.higher; });
      for (auto first = begin; first != end;) {
        const auto last = std::find_if(first, end, [&](const Side &s) { return s.higher != first->higher; });
        visit(last - first, std::count_if(first, last, [](const Side &s) { return s.ascending; }));
        first = last;
      }
    }
  }

private:
  std::vector<std::size_t> start_;
  std::vector<Side> sides_;
};

std::int64_t count_edges(const Mesh &mesh, MeshCheck &check)
{
  std::int64_t edges = 0;
  EdgeBuckets(mesh).for_each_edge([&](std::ptrdiff_t triangles, std::ptrdiff_t ascending) {
    ++edges;
    check.open_edges += triangles == 1 ? 1 : 0;
    check.non_manifold_edges += triangles > 2 ? 1 : 0;
    check.misoriented_edges += triangles == 2 && ascending != 1 ? 1 : 0;
  });
  return edges;
}

std::int64_t count_shells(const Mesh &mesh)
{
  std::vector<PointId> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), PointId{0});
  const auto find = [&](PointId p) {
    while (parent[p] != p)
      p = parent[p] = parent[parent[p]];
    return p;
  };
  for (const Triangle &t : mesh.triangles)
    for (int i = 1; i < 3; ++i)
      parent[find(t[i])] = find(t[0]);
  std::int64_t shells = 0;
  for (PointId p = 0; p < parent.size(); ++p)
    shells += parent[p] == p ? 1 : 0;
  return shells;
}

void measure(const Mesh &mesh, MeshCheck &check)
{
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 normal = doubled_area_normal(mesh, t);
    check.area_mm2 += 0.5 * std::hypot(normal[0], normal[1], normal[2]);
  }
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    for (int i = 0; i < 3; ++i) {
      const double coordinate = mesh.points[p][i];
      check.bounds_low_mm[i] = p == 0 ? coordinate : std::min(check.bounds_low_mm[i], coordinate);
      check.bounds_high_mm[i] = p == 0 ? coordinate : std::max(check.bounds_high_mm[i], coordinate);
    }
  check.volume_mm3 = signed_volume_mm3(mesh);
}

} // namespace

double signed_volume_mm3(const Mesh &mesh)
{
  if (mesh.points.empty())
    return 0;
  double volume = 0; // from a point of the mesh, so that a far origin costs no digits
  const Vec3 apex = to_vec3(mesh.points.front());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 normal = cross(minus(corner(mesh, t, 0), apex), minus(corner(mesh, t, 1), apex));
    volume += dot(normal, minus(corner(mesh, t, 2), apex)) / 6;
  }
  return volume;
}

MeshCheck check_mesh(const Mesh &mesh)
{
  MeshCheck check;
  check.points = static_cast<std::int64_t>(mesh.points.size());
  check.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  const std::int64_t edges = count_edges(mesh, check);
  check.shells = count_shells(mesh);
  check.euler_characteristic = check.points - edges + check.triangles;
  check.watertight =
      check.triangles > 0 && check.open_edges == 0 && check.non_manifold_edges == 0 && check.misoriented_edges == 0;
  if (check.watertight)
    check.genus = static_cast<double>(check.shells) - static_cast<double>(check.euler_characteristic) / 2;
  measure(mesh, check);
  return check;
}

MeshCheck operator+(const MeshCheck &a, const MeshCheck &b)
{
  if (a.triangles == 0 || b.triangles == 0)
    return a.triangles == 0 ? b : a;
  MeshCheck sum = a;
  sum.points += b.points;
  sum.triangles += b.triangles;
  sum.shells += b.shells;
  sum.open_edges += b.open_edges;
  sum.non_manifold_edges += b.non_manifold_edges;
  sum.misoriented_edges += b.misoriented_edges;
  sum.euler_characteristic += b.euler_characteristic;
  sum.watertight = a.watertight && b.watertight;
  sum.genus = sum.watertight ? a.genus + b.genus : 0;
  sum.area_mm2 += b.area_mm2;
  sum.volume_mm3 += b.volume_mm3;
  for (int i = 0; i < 3; ++i) {
    sum.bounds_low_mm[i] = std::min(a.bounds_low_mm[i], b.bounds_low_mm[i]);
    sum.bounds_high_mm[i] = std::max(a.bounds_high_mm[i], b.bounds_high_mm[i]);
  }
  return sum;
}

} // namespace volsurf
