#include "volsurf/core/differences.h"

#include "volsurf/core/vectorise.h"

#include <algorithm>

namespace volsurf {

VOLSURF_VECTORISE
void mark_differences(const std::uint32_t *a, const std::uint32_t *b, std::int64_t count, std::uint64_t *words)
{
  constexpr std::int64_t kBits = 64;
  for (; count > 0; count -= kBits, a += kBits, b += kBits, ++words) {
    const std::int64_t length = std::min(kBits, count);
    const std::int64_t in_lanes = length - length % kLanes;
    UInt32x8 any = {};
    for (std::int64_t x = 0; x < in_lanes; x += kLanes)
      any |= lanes_at<UInt32x8>(a + x) ^ lanes_at<UInt32x8>(b + x);
    std::uint64_t word = 0;
    for (std::int64_t x = in_lanes; x < length; ++x)
      word |= static_cast<std::uint64_t>(a[x] != b[x]) << x;
    if (word == 0 && set_of_lanes(any != 0) == 0)
      continue; // as nearly everywhere in a boundary
    for (std::int64_t x = 0; x < in_lanes; x += kLanes)
      word |= static_cast<std::uint64_t>(set_of_lanes(lanes_at<UInt32x8>(a + x) != lanes_at<UInt32x8>(b + x))) << x;
    *words = word;
  }
}

} // namespace volsurf
