#include "volsurf/compare/pseudonormals.h"

#include "volsurf/compare/edges.h"
#include "volsurf/core/vec3.h"

#include <numeric>

namespace volsurf {

namespace {

/// The corners of all triangles, 3 t + i, in groups that go round one point of one sheet.
class CornerGroups {
public:
  explicit CornerGroups(std::size_t triangles) : parent_(3 * triangles)
  {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t find(std::size_t corner)
  {
    while (parent_[corner] != corner)
      corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }

  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

private:
  std::vector<std::size_t> parent_;
};

std::vector<Vec3> unit_normals(const Mesh &mesh)
{
  std::vector<Vec3> normals(mesh.triangles.size());
  for (std::size_t t = 0; t < normals.size(); ++t) {
    const Vec3 normal = doubled_area_normal(mesh, t);
    normals[t] = plus({0, 0, 0}, 1 / length(normal), normal);
  }
  return normals;
}

double angle_at(const Mesh &mesh, std::size_t t, int i)
{
  const Vec3 here = corner(mesh, t, i);
  const Vec3 to_next = minus(corner(mesh, t, (i + 1) % 3), here);
  const Vec3 to_last = minus(corner(mesh, t, (i + 2) % 3), here);
  return std::atan2(length(cross(to_next, to_last)), dot(to_next, to_last));
}

Point to_point(const Vec3 &v)
{
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

constexpr std::size_t side_feature(std::size_t i)
{
  return static_cast<std::size_t>(Feature::side0) + i;
}

/// Two triangles that run through their edge in opposite directions share its ends and its normal.
void join_over(const Side &a, const Side &b, const std::vector<Vec3> &normals, CornerGroups &groups,
               Pseudonormals &result)
{
  const auto start = [](const Side &s) { return 3 * std::size_t{s.triangle} + s.corner; };
  const auto end = [](const Side &s) { return 3 * std::size_t{s.triangle} + (s.corner + 1U) % 3; };
  groups.join(start(a), end(b));
  groups.join(end(a), start(b));
  const Point sum = to_point(plus(normals[a.triangle], 1, normals[b.triangle]));
  result[a.triangle][side_feature(a.corner)] = sum;
  result[b.triangle][side_feature(b.corner)] = sum;
}

void set_corner_normals(const Mesh &mesh, const std::vector<Vec3> &normals, CornerGroups &groups, Pseudonormals &result)
{
  std::vector<Vec3> sums(3 * mesh.triangles.size(), Vec3{0, 0, 0});
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      Vec3 &sum = sums[groups.find(3 * t + static_cast<std::size_t>(i))];
      sum = plus(sum, angle_at(mesh, t, i), normals[t]);
    }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      result[t][i] = to_point(sums[groups.find(3 * t + i)]);
}

} // namespace

Pseudonormals find_pseudonormals(const Mesh &mesh)
{
  const std::vector<Vec3> normals = unit_normals(mesh);
  Pseudonormals result(mesh.triangles.size());
  for (std::size_t t = 0; t < result.size(); ++t)
    result[t].fill(to_point(normals[t]));
  CornerGroups groups(mesh.triangles.size());
  for_each_edge(mesh, [&](auto first, auto last) {
    if (last - first == 2 && first->ascending != (first + 1)->ascending)
      join_over(*first, *(first + 1), normals, groups, result);
  });
  set_corner_normals(mesh, normals, groups, result);
  return result;
}

} // namespace volsurf
