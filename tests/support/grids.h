// Grids that lie in the world in any way.
#pragma once

#include "support/fields.h"

#include "volsurf/core/grid.h"

namespace volsurf::support {

/// Turns `m` about an axis.
inline Mat3 turned(const Mat3 &m, int axis, double angle)
{
  const auto a = static_cast<std::size_t>((axis + 1) % 3);
  const auto b = static_cast<std::size_t>((axis + 2) % 3);
  Mat3 result = m;
  for (std::size_t column = 0; column < 3; ++column) {
    result[a][column] = std::cos(angle) * m[a][column] - std::sin(angle) * m[b][column];
    result[b][column] = std::sin(angle) * m[a][column] + std::cos(angle) * m[b][column];
  }
  return result;
}

/// Oblique, anisotropic, shifted, mirrored or not. Its size is 5 x 6 x 7.
inline Grid any_grid(Dice &dice)
{
  Grid grid;
  grid.size = {5, 6, 7};
  for (int axis = 0; axis < 3; ++axis) {
    grid.spacing_mm[axis] = 0.125 * static_cast<double>(dice.between(2, 24));
    grid.origin_mm[axis] = 0.5 * static_cast<double>(dice.between(-200, 200));
    if (dice.one_in(2))
      for (int row = 0; row < 3; ++row)
        grid.direction[row][axis] *= -1;
  }
  for (int axis = 0; axis < 3; ++axis)
    if (dice.one_in(2))
      grid.direction = turned(grid.direction, axis, 0.1 * static_cast<double>(dice.between(-30, 30)));
  return grid;
}

} // namespace volsurf::support
