// A stable sort by decreasing float key, linear in the number of items.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace volsurf {

/// Bits that ascend where finite or infinite floats descend. Both zeros get the same bits; NaN is not allowed.
inline std::uint32_t descending_bits(float value)
{
  const float without_sign_of_zero = value + 0.0F;
  std::uint32_t bits = 0;
  std::memcpy(&bits, &without_sign_of_zero, sizeof bits);
  return (bits & 0x80000000U) ? bits : ~(bits | 0x80000000U);
}

/// Sorts items by key_of(item), a std::uint32_t, ascending; equal keys keep their order. O(items). What is in `second`
/// is lost; who sorts often keeps it, since new memory takes as long as a pass.
template <typename Item, typename KeyOf>
void radix_sort(std::vector<Item> &items, std::vector<Item> &second, KeyOf key_of)
{
  constexpr int kBits = 11;
  constexpr int kPasses = 3;
  constexpr std::uint32_t kBuckets = 1U << kBits;
  std::array<std::vector<std::size_t>, kPasses> starts;
  starts.fill(std::vector<std::size_t>(kBuckets + 1));
  for (const Item &item : items)
    for (int pass = 0; pass < kPasses; ++pass)
      ++starts[pass][(key_of(item) >> (pass * kBits) & (kBuckets - 1)) + 1];

  second.resize(items.size());
  for (int pass = 0; pass < kPasses; ++pass) {
    auto &start = starts[pass];
    for (std::uint32_t bucket = 0; bucket < kBuckets; ++bucket)
      start[bucket + 1] += start[bucket];
    for (const Item &item : items)
      second[start[key_of(item) >> (pass * kBits) & (kBuckets - 1)]++] = item;
    items.swap(second);
  }
}

template <typename Item, typename KeyOf> void radix_sort(std::vector<Item> &items, KeyOf key_of)
{
  std::vector<Item> second;
  radix_sort(items, second, key_of);
}

} // namespace volsurf
