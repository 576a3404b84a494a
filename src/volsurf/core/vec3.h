// Arithmetic of Vec3, and of a mesh's triangles in it.
#pragma once

#include "volsurf/core/grid.h"
#include "volsurf/core/mesh.h"

#include <cmath>

namespace volsurf {

inline Vec3 to_vec3(const Point &p)
{
  return {p[0], p[1], p[2]};
}

inline Vec3 minus(const Vec3 &a, const Vec3 &b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// a + factor * b
inline Vec3 plus(const Vec3 &a, double factor, const Vec3 &b)
{
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

inline Vec3 scaled(double factor, const Vec3 &a)
{
  return {factor * a[0], factor * a[1], factor * a[2]};
}

inline double dot(const Vec3 &a, const Vec3 &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vec3 cross(const Vec3 &a, const Vec3 &b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double length(const Vec3 &a)
{
  return std::sqrt(dot(a, a));
}

/// The corner i (0, 1, 2) of triangle t.
inline Vec3 corner(const Mesh &mesh, std::size_t t, int i)
{
  return to_vec3(mesh.points[mesh.triangles[t][i]]);
}

/// Normal to triangle t, as long as twice its area.
inline Vec3 doubled_area_normal(const Mesh &mesh, std::size_t t)
{
  const Vec3 a = corner(mesh, t, 0);
  return cross(minus(corner(mesh, t, 1), a), minus(corner(mesh, t, 2), a));
}

} // namespace volsurf
