#include "volsurf/field/edge_locator.h"

#include <cmath>

namespace volsurf {

namespace {

constexpr int kStepsToLimit = 4; ///< of the way to the edge

/// A line through a volume.
class Line {
public:
  Line(const SmoothVolume &volume, const Vec3 &start, const Vec3 &direction)
      : volume_(volume), start_(start), direction_(direction)
  {
    for (int axis = 0; axis < 3; ++axis)
      step_[axis] = direction[axis] / volume.grid().spacing_mm[axis];
  }

  /// Of g along the line.
  double slope(double t_mm) const
  {
    const Vec3 g = volume_.gradient_at(at(t_mm));
    return g[0] * direction_[0] + g[1] * direction_[1] + g[2] * direction_[2];
  }

  /// Laplacian(g) + g_ww, positive on the side of lower g.
  double plus(double t_mm) const
  {
    const auto [g, second, mixed] = volume_.derivatives_at(at(t_mm));
    const double squared = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    if (!(squared > 0))
      return 0;
    const double along = g[0] * g[0] * second[0] + g[1] * g[1] * second[1] + g[2] * g[2] * second[2] +
                         2 * (g[1] * g[2] * mixed[0] + g[0] * g[2] * mixed[1] + g[0] * g[1] * mixed[2]);
    return second[0] + second[1] + second[2] + along / squared;
  }

private:
  Vec3 at(double t_mm) const
  {
    return {start_[0] + t_mm * step_[0], start_[1] + t_mm * step_[1], start_[2] + t_mm * step_[2]};
  }

  const SmoothVolume &volume_;
  Vec3 start_;
  Vec3 direction_;
  Vec3 step_{}; // in voxels per mm
};

/// The zero of a straight line through two values of opposite signs.
double zero_between(double a, double value_a, double b, double value_b)
{
  return a + (b - a) * value_a / (value_a - value_b);
}

} // namespace

std::optional<double> EdgeLocator::find(const Vec3 &index, const Vec3 &direction, double limit_mm) const
{
  const Line line(volume_, index, direction);
  const double sign = line.slope(0) >= 0 ? 1 : -1; // so that the value falls along the line where there is an edge
  double near = 0;
  double value_near = sign * line.plus(0);
  const double step = (value_near >= 0 ? limit_mm : -limit_mm) / kStepsToLimit;
  double far = step;
  double value_far = sign * line.plus(far);
  while ((value_far > 0) == (value_near > 0)) {
    near = far;
    value_near = value_far;
    far += step;
    if (std::abs(far) > limit_mm)
      return std::nullopt;
    value_far = sign * line.plus(far);
  }
  const double first = zero_between(near, value_near, far, value_far);
  const double value_first = sign * line.plus(first);
  return (value_first > 0) == (value_near > 0) ? zero_between(first, value_first, far, value_far)
                                               : zero_between(near, value_near, first, value_first);
}

} // namespace volsurf
