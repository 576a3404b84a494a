// Signed distances to simple bodies: millimetres, negative inside. Exact on the surface, and near it to first order.
#pragma once

#include "volsurf/core/vec3.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

/// 0 below `low`, 1 above `high`, a smooth rise between.
inline double smooth_step(double low, double high, double x)
{
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Union with a fillet of about `radius` where the bodies meet.
inline double smooth_union(double a, double b, double radius)
{
  const double h = std::max(radius - std::abs(a - b), 0.0);
  return std::min(a, b) - h * h / (4 * radius);
}

/// Intersection with its edge rounded.
inline double smooth_intersection(double a, double b, double radius)
{
  return -smooth_union(-a, -b, radius);
}

/// Distance to first order: the value of the implicit function over the length of its gradient.
inline double ellipsoid(const Vec3 &p, const Vec3 &centre, const Vec3 &semi_axes)
{
  // Reciprocals, because the compiler computes those of constants itself, and a division costs as much as the rest.
  const Vec3 inverse{1 / semi_axes[0], 1 / semi_axes[1], 1 / semi_axes[2]};
  const Vec3 offset = minus(p, centre);
  const Vec3 scaled{offset[0] * inverse[0], offset[1] * inverse[1], offset[2] * inverse[2]};
  const Vec3 gradient{scaled[0] * inverse[0], scaled[1] * inverse[1], scaled[2] * inverse[2]};
  const double value = length(scaled);
  const double slope = length(gradient);
  // The centre itself has no direction.
  return slope > 0 ? value * (value - 1) / slope : -*std::min_element(semi_axes.begin(), semi_axes.end());
}

/// A place on a tube's axis and the tube's radius there, both in mm.
struct TubePoint {
  Vec3 centre;
  double radius;
};

/// One straight piece of a tube with round ends, the radius linear between them.
inline double tube_piece(const Vec3 &p, const TubePoint &from, const TubePoint &to)
{
  const Vec3 axis = minus(to.centre, from.centre);
  const Vec3 offset = minus(p, from.centre);
  const double t = std::clamp(dot(offset, axis) * (1 / dot(axis, axis)), 0.0, 1.0);
  const Vec3 to_axis{offset[0] - t * axis[0], offset[1] - t * axis[1], offset[2] - t * axis[2]};
  return length(to_axis) - (from.radius + t * (to.radius - from.radius));
}

/// A tube through several points, its bends rounded.
template <std::size_t N> double tube(const Vec3 &p, const std::array<TubePoint, N> &points, double bend_radius)
{
  double distance = tube_piece(p, points[0], points[1]);
  for (std::size_t i = 2; i < N; ++i)
    distance = smooth_union(distance, tube_piece(p, points[i - 1], points[i]), bend_radius);
  return distance;
}

} // namespace volsurf
