#include "volsurf/topology/first_steps.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace volsurf {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// What is known of the cells of a block from their first corners, by axis.
struct CornerBits {
  SampleBits is_high[3]; ///< the first corner is at the high side
  SampleBits crowded[3]; ///< the neighbour on that side is newborn there, too
};

/// What the samples of a block say as corners of the cells on one side of them along x: of those at their high side
/// they are the low corners.
VOLSURF_LANES_INLINE CornerBits bits_of_corners(const CornerRows &corners, std::int64_t block, bool is_high_corner)
{
  CornerBits bits{};
  for (int row = 0; row < 4; ++row) {
    const int corner = (is_high_corner ? 1 : 0) | row << 1;
    const int octant = corner ^ (kOctants - 1); // seen from the corner, the cell is at the other side
    const auto newborn = [&](int o) {
      return lanes_at<SampleBits>(corners[static_cast<std::size_t>(row)] + block * kNewbornWords + kLanes * o);
    };
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1) != 0)
        bits.is_high[axis] |= newborn(octant);
      bits.crowded[axis] |= newborn(octant) & newborn(octant ^ 1 << axis);
    }
  }
  return bits;
}

/// Those of a block of cells, whose high corners are one sample further on.
VOLSURF_LANES_INLINE CornerBits bits_of_cells(CornerBits low, const CornerBits &high, const CornerBits &next_high)
{
  for (int axis = 0; axis < 3; ++axis) {
    low.is_high[axis] |= from_higher(high.is_high[axis], next_high.is_high[axis]);
    low.crowded[axis] |= from_higher(high.crowded[axis], next_high.crowded[axis]);
  }
  return low;
}

/// The steps of eight cells from x on, bit `bit` of their words.
VOLSURF_LANES_INLINE UInt32x8 choose_steps(const CellRows &rows, std::int64_t x, const CornerBits &cells, unsigned bit)
{
  const auto is_set = [&](const SampleBits &words) { return (words & bit) == bit; };
  const auto values_across = [&](int axis, const float *low, const float *high) {
    const Float32x8 values = is_set(cells.is_high[axis]) ? lanes_at<Float32x8>(high + x) : lanes_at<Float32x8>(low + x);
    return is_set(cells.crowded[axis]) ? Float32x8{} - kInfinity : values;
  };
  const auto step_across_axis = [&](int axis) {
    const UInt32x8 to_low = UInt32x8{} + static_cast<BasinId>(2 * axis);
    return is_set(cells.is_high[axis]) ? to_low + 1 : to_low;
  };
  const Float32x8 across_x = values_across(0, rows.level - 1, rows.level + 1);
  const Float32x8 across_y = values_across(1, rows.low_y, rows.high_y);
  const Float32x8 across_z = values_across(2, rows.low_z, rows.high_z);
  const auto y_is_larger = across_y > across_x;
  const Float32x8 best_xy = y_is_larger ? across_y : across_x;
  const UInt32x8 step_xy = y_is_larger ? step_across_axis(1) : step_across_axis(0);
  const auto z_is_larger = across_z > best_xy;
  const Float32x8 best = z_is_larger ? across_z : best_xy;
  const UInt32x8 step = z_is_larger ? step_across_axis(2) : step_xy;

  const UInt32x8 to_exterior = UInt32x8{} + kToExterior;
  const UInt32x8 none = UInt32x8{} + kNoStep;
  const UInt32x8 inner = best == Float32x8{} - kInfinity ? none : step;
  return kFirstStepCode + (best == Float32x8{} + kInfinity ? to_exterior : inner);
}

} // namespace

VOLSURF_VECTORISE
void first_steps(const CellRows &rows, const CornerRows &corners, std::int64_t count, BasinId *codes)
{
  const std::int64_t blocks = block_count(count + 1); // of samples
  CornerBits high = bits_of_corners(corners, 0, true);
  for (std::int64_t block = 0; block < blocks; ++block) {
    const CornerBits next_high = block + 1 < blocks ? bits_of_corners(corners, block + 1, true) : CornerBits{};
    const CornerBits cells = bits_of_cells(bits_of_corners(corners, block, false), high, next_high);
    const std::int64_t begin = block * kBlockSamples;
    for (std::int64_t x = begin; x < std::min(begin + kBlockSamples, count); x += kLanes) {
      const UInt32x8 steps = choose_steps(rows, x, cells, 1U << ((x - begin) / kLanes));
      if (x + kLanes <= count)
        lanes_at<UInt32x8>(codes + x) = steps;
      else
        std::memcpy(codes + x, &steps, static_cast<std::size_t>(count - x) * sizeof(BasinId));
    }
    high = next_high;
  }
}

} // namespace volsurf
