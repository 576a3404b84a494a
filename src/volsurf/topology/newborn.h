// Which cells and faces are newborn at each sample of a row: step C of the region merge.
//
// In: the order of the row's samples and their neighbours, as bits. Out: what is newborn, as bits, 256 samples at a
// time, without branches. Guarantee: exactly the sample order of the merge (I descending, then linear index ascending).
#pragma once

#include "volsurf/topology/cubical_complex.h"
#include "volsurf/topology/sample_order.h"

#include <array>
#include <cstdint>

namespace volsurf {

/// Newborn cells of a star in bits 0 .. 7, newborn faces in bits 8 .. 19.
using NewbornMask = std::uint32_t;
constexpr int kMaskBits = kOctants + kStarFaces;

constexpr unsigned newborn_cells(NewbornMask mask)
{
  return mask & 0xFFU;
}

constexpr unsigned newborn_faces(NewbornMask mask)
{
  return mask >> 8;
}

/// How the patterns of samples on the border of the volume are completed.
///
/// Cells and faces that are not in the volume must not join anything with `none`: they count as newborn, which makes
/// each of them a part of its own that reaches nowhere. With `infinite` they belong to the exterior node: they are
/// not newborn, and the faces between them, of value +inf, have joined them.
class BorderRule {
public:
  BorderRule(const Index3 &samples, Exterior exterior);

  const Index3 &samples() const { return samples_; }

  /// The octants of the star of a sample that are cells of the volume.
  unsigned real_cells(std::int64_t x, std::int64_t y, std::int64_t z) const
  {
    return octants_inside(x, 0) & real_cells_in_row(y, z);
  }

  /// The same as far as the row decides.
  unsigned real_cells_in_row(std::int64_t y, std::int64_t z) const
  {
    return octants_inside(y, 1) & octants_inside(z, 2);
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

/// What tells the order of the samples of row (y, z) and all their neighbours. Rows outside the volume may be any.
struct StarRows {
  OrderRow row;                  ///< (y, z)
  OrderRow next;                 ///< (y + 1, z)
  std::array<OrderRow, 3> above; ///< (y - 1 .. y + 1, z + 1)
};

/// For each block of a row one SampleBits for each bit of a pattern: 1 where the cell or face is newborn at the
/// sample. Cells that are not in the volume are not, of faces that are not the bits are without a meaning.
using NewbornRow = const std::uint32_t *;
constexpr std::int64_t kNewbornWords = std::int64_t{kMaskBits} * kLanes;

/// Finds what is newborn at the samples of row (y, z): block_count(row size) * kNewbornWords words.
void find_newborn(const StarRows &rows, std::int64_t y, std::int64_t z, const BorderRule &border,
                  std::uint32_t *newborn);

} // namespace volsurf
