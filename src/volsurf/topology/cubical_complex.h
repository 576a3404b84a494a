// The cubical complex of a grid, by arithmetic: no cell or face is stored.
//
// A cell is named by its lowest corner's position on the cell grid, a face by its axis (the one it is normal to) and
// its lowest corner's sample; the star of a sample is numbered as core/star.h says.
#pragma once

#include "volsurf/core/grid.h"
#include "volsurf/core/star.h"

#include <cstdint>

namespace volsurf {

/// What lies behind the faces at the border of the volume.
enum class Exterior {
  none,     ///< nothing: border faces join nothing
  infinite, ///< one node of value +infinity, which each border face joins to its cell (the paper)
};

/// A step from a cell to a neighbour: 2 * axis towards lower, 2 * axis + 1 towards higher positions.
using Step = std::uint8_t;
constexpr Step kNoStep = 6;     ///< the cell is the root of its basin
constexpr Step kToExterior = 7; ///< across a border face, to the exterior node

/// Labels of cells hold steps, too, until the basin is known: codes above all basins.
constexpr BasinId kFirstStepCode = 0xFFFFFFF8U;

constexpr BasinId step_code(Step step)
{
  return kFirstStepCode + step;
}

constexpr Step step_of(BasinId code)
{
  return static_cast<Step>(code - kFirstStepCode);
}

/// The step from octant `octant` across the star to its neighbour along `axis`.
constexpr Step step_across(int octant, int axis)
{
  return static_cast<Step>(2 * axis + ((octant >> axis & 1) ? 0 : 1));
}

/// Index arithmetic on the cell grid.
struct CellGrid {
  Index3 size;
  std::int64_t row;   ///< cells from one row (y) to the next
  std::int64_t plane; ///< cells from one plane (z) to the next

  explicit CellGrid(const Index3 &cells) : size(cells), row(cells[0]), plane(cells[0] * cells[1]) {}

  std::int64_t count() const { return plane * size[2]; }
  CellId id(std::int64_t x, std::int64_t y, std::int64_t z) const { return x + row * y + plane * z; }

  /// What a step to a neighbouring cell (not kNoStep, not kToExterior) adds to a cell's id.
  std::int64_t offset(Step step) const
  {
    const std::int64_t stride = step < 2 ? 1 : step < 4 ? row : plane;
    return (step & 1) ? stride : -stride;
  }
};

} // namespace volsurf
