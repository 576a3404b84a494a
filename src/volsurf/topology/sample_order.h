// Which of two neighbouring samples comes first in the sample order, as bits: what step C of the region merge begins
// with.
//
// In: rows of I. Out: a bit per sample and neighbour of lower linear index, 13 of its 26. The sample order is I
// descending, then linear index ascending, so that a sample comes before such a neighbour where its I is larger, and
// what a sample does not say of its other 13 neighbours, they say of it.
//
// Guarantee: exactly the sample order. Plain loops without branches, made for SIMD: eight samples are compared at a
// time and their bits put into eight words, so that no bit has to change its lane.
#pragma once

#include "volsurf/core/vectorise.h"

#include <array>
#include <cstdint>

namespace volsurf {

/// One bit for each of 256 samples of a row: bit i of word j is sample 8 * i + j of the block.
using SampleBits = UInt32x8;
constexpr SampleBits kNoSamples = {};
constexpr std::int64_t kBlockSamples = 32 * std::int64_t{kLanes};

/// The neighbour at offset (dx, dy, dz) has number (dx + 1) + 3 (dy + 1) + 9 (dz + 1); that at (-dx, -dy, -dz) has
/// 26 less this number.
constexpr int kLowerNeighbours = 13;

constexpr int neighbour_number(int dx, int dy, int dz)
{
  return dx + 1 + 3 * (dy + 1) + 9 * (dz + 1);
}

/// For each block of a row one SampleBits for each neighbour of lower index, by number.
using OrderRow = const std::uint32_t *;
constexpr std::int64_t kBlockWords = std::int64_t{kLowerNeighbours} * kLanes;

constexpr std::int64_t block_count(std::int64_t samples)
{
  return (samples + kBlockSamples - 1) / kBlockSamples;
}

/// The rows that hold a row's neighbours of lower index: of its plane, and of the plane below those at y - 1, y, y + 1.
struct LowerRows {
  const float *level;
  std::array<const float *, 3> below;
};

/// The bits of `count` samples: 1 where the sample comes before the neighbour. Reads all rows from -1 to count + 8.
/// `order` has block_count(count) * kBlockWords words; bits of no sample are without a meaning.
void compare_with_lower(const float *row, const LowerRows &lower, std::int64_t count, std::uint32_t *order);

/// That of the i-th sample of a block alone.
VOLSURF_LANES_INLINE SampleBits sample_bit(std::int64_t i)
{
  constexpr SampleBits kWord = {0, 1, 2, 3, 4, 5, 6, 7};
  return kWord == static_cast<std::uint32_t>(i % kLanes) ? kNoSamples + (1U << (i / kLanes)) : kNoSamples;
}

/// The bits of the samples at x + 1; `next` is the block after this one.
VOLSURF_LANES_INLINE SampleBits from_higher(const SampleBits &bits, const SampleBits &next)
{
  const SampleBits wrapped = bits >> 1 | next << 31;
  return __builtin_shufflevector(bits, wrapped, 1, 2, 3, 4, 5, 6, 7, 8);
}

/// The bits of the samples at x - 1; `last` is the block before this one.
VOLSURF_LANES_INLINE SampleBits from_lower(const SampleBits &bits, const SampleBits &last)
{
  const SampleBits wrapped = bits << 1 | last >> 31;
  return __builtin_shufflevector(wrapped, bits, 7, 8, 9, 10, 11, 12, 13, 14);
}

} // namespace volsurf
