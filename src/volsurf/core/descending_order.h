// The order of many floats, found by all threads.
//
// Each slab of values puts its places into buckets by the first bits of their keys; each bucket, which fits into a
// cache unless most values are nearly the same, is then sorted by the others.
#pragma once

#include <cstdint>
#include <vector>

namespace volsurf {

/// The places of values, fewer than 2^32 and none of them NaN, by decreasing value; those of equal values ascend.
/// What is in `memory` is lost; it gets as long as the values. O(values).
std::vector<std::uint32_t> descending_order(const std::vector<float> &values, std::vector<std::uint32_t> &memory);

} // namespace volsurf
