// Which cells and faces are newborn at each sample of a row: step C of the region merge.
//
// In: rows of I. Out: one bit pattern per sample. Guarantee: exactly the sample order of the merge (I descending, then
// linear index ascending). Plain loops without branches, made for SIMD.
#pragma once

#include "volsurf/topology/cubical_complex.h"

#include <array>
#include <cstdint>

namespace volsurf {

/// Newborn cells of a star in bits 0 .. 7, newborn faces in bits 8 .. 19.
using NewbornMask = std::uint32_t;

constexpr unsigned newborn_cells(NewbornMask mask)
{
  return mask & 0xFFU;
}

constexpr unsigned newborn_faces(NewbornMask mask)
{
  return mask >> 8;
}

/// rows[3 * (dz + 1) + dy + 1] is the row of samples at (y + dy, z + dz). Each can be read from -1 to count.
using StarRows = std::array<const float *, 9>;

/// The pattern of each of the `count` samples of the middle row. Cells and faces that reach outside the volume get bits
/// without a meaning, which BorderRule then sets.
void newborn_masks(const StarRows &rows, std::int64_t count, NewbornMask *masks);

/// How the patterns of samples on the border of the volume are completed.
///
/// Cells and faces that are not in the volume must not join anything with `none`: they count as newborn, which makes
/// each of them a part of its own that reaches nowhere. With `infinite` they belong to the exterior node: they are not
/// newborn, and the faces between them, of value +inf, have joined them.
class BorderRule {
public:
  BorderRule(const Index3 &samples, Exterior exterior);

  /// The octants of the star of a sample that are cells of the volume.
  unsigned real_cells(std::int64_t x, std::int64_t y, std::int64_t z) const
  {
    return octants_inside(x, 0) & octants_inside(y, 1) & octants_inside(z, 2);
  }

  NewbornMask complete(NewbornMask mask, unsigned real_cells) const
  {
    return (mask & keep_[real_cells]) | set_[real_cells];
  }

private:
  /// As far as the position along one axis decides.
  unsigned octants_inside(std::int64_t position, int axis) const
  {
    constexpr unsigned kLowOctants[] = {0x55, 0x33, 0x0F};
    const unsigned above = position == 0 ? ~kLowOctants[axis] : 0xFFU;
    const unsigned below = position == samples_[axis] - 1 ? kLowOctants[axis] : 0xFFU;
    return above & below & 0xFFU;
  }

  Index3 samples_;
  std::array<NewbornMask, 256> keep_{};
  std::array<NewbornMask, 256> set_{};
};

} // namespace volsurf
