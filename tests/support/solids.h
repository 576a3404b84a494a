// Meshes of bodies whose distances and volumes are known.
#pragma once

#include "volsurf/core/grid.h"
#include "volsurf/core/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace volsurf::test {

inline Point to_point(const Vec3 &v)
{
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

/// A regular octahedron whose triangles are cut in four `cuts` times, all points on the sphere; normals outwards.
inline Mesh sphere_mesh(const Vec3 &centre, double radius, int cuts)
{
  std::vector<Vec3> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Triangle> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int cut = 0; cut < cuts; ++cut) {
    std::map<std::pair<PointId, PointId>, PointId> middles;
    const auto middle = [&](PointId a, PointId b) {
      const auto [found, is_new] =
          middles.insert({{std::min(a, b), std::max(a, b)}, static_cast<PointId>(points.size())});
      if (is_new) {
        const Vec3 m{points[a][0] + points[b][0], points[a][1] + points[b][1], points[a][2] + points[b][2]};
        const double length = std::hypot(m[0], m[1], m[2]);
        points.push_back({m[0] / length, m[1] / length, m[2] / length});
      }
      return found->second;
    };
    std::vector<Triangle> quarters;
    for (const auto &[a, b, c] : triangles) {
      const PointId ab = middle(a, b);
      const PointId bc = middle(b, c);
      const PointId ca = middle(c, a);
      quarters.insert(quarters.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles = quarters;
  }
  Mesh mesh;
  for (const Vec3 &p : points)
    mesh.points.push_back(to_point({centre[0] + radius * p[0], centre[1] + radius * p[1], centre[2] + radius * p[2]}));
  mesh.triangles = triangles;
  return mesh;
}

/// A box with 12 triangles, normals outwards.
inline Mesh box_mesh(const Vec3 &low, const Vec3 &high)
{
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back(
        to_point({(i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1], (i & 4) != 0 ? high[2] : low[2]}));
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Each triangle cut in four, at the middles of its sides: the same surface. Points are not shared.
inline Mesh cut_in_four(const Mesh &mesh)
{
  Mesh fine;
  for (const Triangle &triangle : mesh.triangles) {
    std::array<Point, 6> p{};
    for (int i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        p[i][axis] = mesh.points[triangle[i]][axis];
        p[3 + i][axis] = (mesh.points[triangle[i]][axis] + mesh.points[triangle[(i + 1) % 3]][axis]) / 2;
      }
    const auto first = static_cast<PointId>(fine.points.size());
    fine.points.insert(fine.points.end(), p.begin(), p.end());
    for (const Triangle &t : {Triangle{0, 3, 5}, Triangle{3, 1, 4}, Triangle{5, 4, 2}, Triangle{3, 4, 5}})
      fine.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return fine;
}

/// All of both.
inline Mesh joined(Mesh a, const Mesh &b)
{
  const auto first = static_cast<PointId>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const Triangle &t : b.triangles)
    a.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  return a;
}

/// Every point p becomes scale * rotation * p + shift.
inline Mesh moved(Mesh mesh, const Mat3 &rotation, const Vec3 &shift, double scale = 1)
{
  for (Point &p : mesh.points) {
    Vec3 place = shift;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        place[row] += scale * rotation[row][column] * p[column];
    p = to_point(place);
  }
  return mesh;
}

constexpr Mat3 kNoRotation{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

/// Round an axis that no grid has.
inline Mat3 skew_rotation()
{
  const Mat3 round_z{Vec3{0.8, -0.6, 0}, Vec3{0.6, 0.8, 0}, Vec3{0, 0, 1}};
  const Mat3 round_x{Vec3{1, 0, 0}, Vec3{0, 5.0 / 13, -12.0 / 13}, Vec3{0, 12.0 / 13, 5.0 / 13}};
  Mat3 product{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      for (int i = 0; i < 3; ++i)
        product[row][column] += round_x[row][i] * round_z[i][column];
  return product;
}

} // namespace volsurf::test
