#include "volsurf/field/edge_locator.h"

#include "volsurf/core/vec3.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

constexpr int kStepsToLimit = 4; ///< of the way to the edge

/// The sd of an edge's place under white noise is so many times sigma times the noise of the gradient over the
/// gradient, measured on planes.
constexpr double kErrorOfNoise = 2.1;

/// Laplacian(g) + g_ww, positive on the side of lower g.
double plus_of(const Derivatives &derivatives)
{
  const auto &[g, second, mixed] = derivatives;
  const double squared = dot(g, g);
  if (!(squared > 0))
    return 0;
  const double along = g[0] * g[0] * second[0] + g[1] * g[1] * second[1] + g[2] * g[2] * second[2] +
                       2 * (g[1] * g[2] * mixed[0] + g[0] * g[2] * mixed[1] + g[0] * g[1] * mixed[2]);
  return second[0] + second[1] + second[2] + along / squared;
}

/// The zero of a straight line through two values of opposite signs.
double zero_between(double a, double value_a, double b, double value_b)
{
  return a + (b - a) * value_a / (value_a - value_b);
}

} // namespace

EdgeLocator::EdgeLocator(const Volume &volume, double sigma_mm, double gradient_noise)
    : volume_(volume, sigma_mm),
      error_times_gradient_(kErrorOfNoise * std::max(sigma_mm, kLeastBlurVoxels * smallest_spacing_mm(volume.grid)) *
                            gradient_noise)
{
}

std::optional<LocatedEdge> EdgeLocator::find(const Vec3 &index, const Vec3 &direction, double limit_mm) const
{
  Vec3 voxels_per_mm{};
  for (int axis = 0; axis < 3; ++axis)
    voxels_per_mm[axis] = direction[axis] / volume_.grid().spacing_mm[axis];
  const Derivatives start = volume_.derivatives_at(index);
  const double sign = dot(start.gradient, direction) >= 0 ? 1 : -1; // so that PLUS falls along the line at an edge
  const auto value_at = [&](double t_mm) {
    return sign * plus_of(volume_.derivatives_at(plus(index, t_mm, voxels_per_mm)));
  };
  double near = 0;
  double value_near = sign * plus_of(start);
  const double step = (value_near >= 0 ? limit_mm : -limit_mm) / kStepsToLimit;
  double far = step;
  double value_far = value_at(far);
  while ((value_far > 0) == (value_near > 0)) {
    near = far;
    value_near = value_far;
    far += step;
    if (std::abs(far) > limit_mm)
      return std::nullopt;
    value_far = value_at(far);
  }
  const double first = zero_between(near, value_near, far, value_far);
  const double value_first = value_at(first);
  const double way_mm = (value_first > 0) == (value_near > 0) ? zero_between(first, value_first, far, value_far)
                                                              : zero_between(near, value_near, first, value_first);
  const double gradient = length(volume_.derivatives_at(plus(index, way_mm, voxels_per_mm)).gradient);
  if (!(gradient > 0))
    return std::nullopt; // where all is flat PLUS is 0, too
  return LocatedEdge{way_mm, error_times_gradient_ / gradient};
}

} // namespace volsurf
