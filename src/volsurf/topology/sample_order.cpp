#include "volsurf/topology/sample_order.h"

#include <algorithm>

namespace volsurf {

VOLSURF_VECTORISE
void compare_with_lower(const float *row, const LowerRows &lower, std::int64_t count, std::uint32_t *order)
{
  const auto &[level, below] = lower;
  const float *const neighbours[kLowerNeighbours] = {below[0] - 1, below[0],     below[0] + 1, below[1] - 1, below[1],
                                                     below[1] + 1, below[2] - 1, below[2],     below[2] + 1, level - 1,
                                                     level,        level + 1,    row - 1};
  for (std::int64_t block = 0; block < count; block += kBlockSamples) {
    SampleBits bits[kLowerNeighbours] = {};
    const std::int64_t last = std::min(block + kBlockSamples, (count + kLanes - 1) / kLanes * kLanes) - kLanes;
    for (std::int64_t x = last; x >= block; x -= kLanes) {
      const Float32x8 v = lanes_at<Float32x8>(row + x);
      for (int i = 0; i < kLowerNeighbours; ++i)
        bits[i] += bits[i] - static_cast<SampleBits>(v > lanes_at<Float32x8>(neighbours[i] + x));
    }
    for (int i = 0; i < kLowerNeighbours; ++i, order += kLanes)
      lanes_at<SampleBits>(order) = bits[i];
  }
}

} // namespace volsurf
