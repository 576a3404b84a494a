// The cubical complex of a grid, by arithmetic: no cell or face is stored.
//
// A cell is named by its lowest corner's position on the cell grid, a face by its axis (the one it is normal to) and
// its lowest corner's sample. The star of a sample is the up to 8 cells and 12 faces that have it as a corner:
//
// - octant o of sample (x, y, z) is the cell at (x-1, y-1, z-1) + (o & 1, o >> 1 & 1, o >> 2 & 1);
// - star face f = 4 * axis + k lies between the octants lower_octant(f) and upper_octant(f), which differ in the bit of
//   its axis; k counts the other two bits, lower axis first, so that f ascends by axis, then by the linear index of the
//   face's lowest corner, as the order K of faces wants it.
#pragma once

#include "volsurf/core/grid.h"

#include <cstdint>

namespace volsurf {

/// What lies behind the faces at the border of the volume.
enum class Exterior {
  none,     ///< nothing: border faces join nothing
  infinite, ///< one node of value +infinity, which each border face joins to its cell (the paper)
};

constexpr int kOctants = 8;
constexpr int kStarFaces = 12;

constexpr int lower_octant(int star_face)
{
  constexpr std::uint8_t kLower[kStarFaces] = {0, 2, 4, 6, 0, 1, 4, 5, 0, 1, 2, 3};
  return kLower[star_face];
}

constexpr int upper_octant(int star_face)
{
  constexpr std::uint8_t kUpper[kStarFaces] = {1, 3, 5, 7, 2, 3, 6, 7, 4, 5, 6, 7};
  return kUpper[star_face];
}

/// The face of the star between octant `octant` and its neighbour along `axis`.
constexpr int star_face_of(int octant, int axis)
{
  const int low_bits = octant & ((1 << axis) - 1);
  const int high_bits = (octant >> (axis + 1)) << axis;
  return 4 * axis + (high_bits | low_bits);
}

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
