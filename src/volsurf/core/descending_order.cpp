#include "volsurf/core/descending_order.h"

#include "volsurf/core/parallel.h"
#include "volsurf/core/radix_sort.h"

#include <algorithm>
#include <array>

namespace volsurf {

namespace {

constexpr int kDigitBits = 9;
constexpr std::uint32_t kDigits = 1U << kDigitBits;
constexpr int kLowBits = 2 * kDigitBits; ///< of a key, which are left to the buckets
constexpr std::uint32_t kBuckets = 1U << (32 - kLowBits);
constexpr std::int64_t kBucketsPerSlab = 4;
constexpr std::int64_t kValuesPerSlab = 1 << 17; ///< many enough for counts of buckets to take half a byte per value

/// Per slab of values and bucket: a count, then where the next value goes.
using BucketCounts = std::vector<std::vector<std::uint32_t>>;

struct Keyed {
  std::uint32_t key;
  std::uint32_t place;
};

BucketCounts count_buckets(const std::vector<float> &values)
{
  const auto count = static_cast<std::int64_t>(values.size());
  BucketCounts counts(static_cast<std::size_t>(slab_count(count, kValuesPerSlab)));
  parallel_for_slabs(count, kValuesPerSlab, [&](const Slab &slab) {
    std::vector<std::uint32_t> slab_counts(kBuckets);
    for (std::int64_t i = slab.begin; i < slab.end; ++i)
      ++slab_counts[descending_bits(values[i]) >> kLowBits];
    counts[slab.index] = std::move(slab_counts);
  });
  return counts;
}

void counts_to_starts(BucketCounts &counts)
{
  std::uint32_t start = 0;
  for (std::uint32_t bucket = 0; bucket < kBuckets; ++bucket)
    for (std::vector<std::uint32_t> &slab_counts : counts) {
      const std::uint32_t count = slab_counts[bucket];
      slab_counts[bucket] = start;
      start += count;
    }
}

using DigitCounts = std::array<std::uint32_t, kDigits>;

void counts_to_starts(DigitCounts &counts)
{
  std::uint32_t start = 0;
  for (std::uint32_t &count : counts) {
    start += count;
    count = start - count;
  }
}

std::uint32_t low_digit(std::uint32_t key)
{
  return key & (kDigits - 1);
}

std::uint32_t high_digit(std::uint32_t key)
{
  return key >> kDigitBits & (kDigits - 1);
}

/// Sorts a bucket's places by their keys' low bits.
void sort_bucket(const std::uint32_t *keys, std::uint32_t *places, std::uint32_t count, std::vector<Keyed> &memory)
{
  if (std::is_sorted(keys, keys + count)) // as where most values are equal: the one bucket of many
    return;
  DigitCounts low{};
  DigitCounts high{};
  for (std::uint32_t i = 0; i < count; ++i) {
    ++low[low_digit(keys[i])];
    ++high[high_digit(keys[i])];
  }
  counts_to_starts(low);
  counts_to_starts(high);
  memory.resize(count);
  for (std::uint32_t i = 0; i < count; ++i)
    memory[low[low_digit(keys[i])]++] = {keys[i], places[i]};
  for (const Keyed &keyed : memory)
    places[high[high_digit(keyed.key)]++] = keyed.place;
}

} // namespace

std::vector<std::uint32_t> descending_order(const std::vector<float> &values, std::vector<std::uint32_t> &memory)
{
  std::vector<std::uint32_t> places(values.size());
  if (values.empty())
    return places;
  BucketCounts starts = count_buckets(values);
  counts_to_starts(starts);
  std::vector<std::uint32_t> &keys = memory;
  keys.resize(values.size());
  parallel_for_slabs(static_cast<std::int64_t>(values.size()), kValuesPerSlab, [&](const Slab &slab) {
    std::vector<std::uint32_t> &next = starts[slab.index];
    for (std::int64_t i = slab.begin; i < slab.end; ++i) {
      const std::uint32_t key = descending_bits(values[i]);
      const std::uint32_t at = next[key >> kLowBits]++;
      keys[at] = key;
      places[at] = static_cast<std::uint32_t>(i);
    }
  });
  const std::vector<std::uint32_t> &ends = starts.back(); // of buckets, now that the last slab is done
  parallel_for_slabs(kBuckets, kBucketsPerSlab, [&](const Slab &buckets) {
    std::vector<Keyed> sorted;
    for (std::int64_t bucket = buckets.begin; bucket < buckets.end; ++bucket) {
      const std::uint32_t begin = bucket == 0 ? 0 : ends[bucket - 1];
      sort_bucket(keys.data() + begin, places.data() + begin, ends[bucket] - begin, sorted);
    }
  });
  return places;
}

} // namespace volsurf
