#include "volsurf/topology/star_patterns.h"

#include "volsurf/topology/star_tables.h"

#include <algorithm>

namespace volsurf {

namespace {

/// By bit of the pattern, with room for the squares that are transposed.
struct PatternBits {
  SampleBits &operator[](int i) { return bits[i]; }
  const SampleBits &operator[](int i) const { return bits[i]; }

  SampleBits bits[3 * kLanes];
};
static_assert(kMaskBits <= 3 * kLanes);

VOLSURF_LANES_INLINE PatternBits bits_of_block(NewbornRow newborn, std::int64_t block)
{
  PatternBits bits{};
  for (int i = 0; i < kMaskBits; ++i)
    bits[i] = lanes_at<SampleBits>(newborn + block * kNewbornWords + kLanes * i);
  return bits;
}

VOLSURF_LANES_INLINE SampleBits samples_with_deep_octant(const PatternBits &newborn)
{
  SampleBits deep = kNoSamples;
  for (int o = 0; o < kOctants; ++o)
    deep |= newborn[o] & newborn[o ^ 1] & newborn[o ^ 2] & newborn[o ^ 4];
  return deep;
}

/// Where a walk over the faces that are not newborn, from the first octant that is not newborn, does not get to all
/// other such octants: two parts reach outside there, or the way is longer than the walk, which is rare.
VOLSURF_LANES_INLINE SampleBits samples_with_parts(const PatternBits &newborn)
{
  constexpr int kWalks = 2; // over all faces: after one 4 times as many samples are left, after three 2 % less
  SampleBits reached[kOctants];
  SampleBits before = kNoSamples;
  for (int o = 0; o < kOctants; ++o) {
    reached[o] = ~(newborn[o] | before);
    before |= ~newborn[o];
  }
  for (int walk = 0; walk < kWalks; ++walk)
    for (int f = 0; f < kStarFaces; ++f) {
      SampleBits &lower = reached[lower_octant(f)];
      SampleBits &upper = reached[upper_octant(f)];
      const SampleBits both = (lower | upper) & ~newborn[kOctants + f];
      lower |= both;
      upper |= both;
    }
  SampleBits missed = kNoSamples;
  for (int o = 0; o < kOctants; ++o)
    missed |= ~(newborn[o] | reached[o]);
  return missed;
}

/// Turns each eight words of eight rows into rows of columns.
VOLSURF_LANES_INLINE void transpose(SampleBits *rows)
{
  for (int i = 0; i < 4; ++i) {
    const SampleBits a = rows[i];
    const SampleBits b = rows[i + 4];
    rows[i] = __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
    rows[i + 4] = __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
  }
  for (const int i : {0, 1, 4, 5}) {
    const SampleBits a = rows[i];
    const SampleBits b = rows[i + 2];
    rows[i] = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
    rows[i + 2] = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
  }
  for (const int i : {0, 2, 4, 6}) {
    const SampleBits a = rows[i];
    const SampleBits b = rows[i + 1];
    rows[i] = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    rows[i + 1] = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  }
}

/// That of a sample of the block, after transpose().
VOLSURF_LANES_INLINE NewbornMask pattern_of(const PatternBits &columns, std::int64_t sample)
{
  const std::uint32_t bit = 1U << (sample / kLanes);
  NewbornMask mask = 0;
  for (int i = 0; i < 3; ++i)
    mask |= set_of_lanes((columns[static_cast<int>(sample % kLanes) + kLanes * i] & bit) == bit) << (kLanes * i);
  return mask;
}

/// The bits in the order of their samples: bit k of word i is sample 64 * i + k.
VOLSURF_LANES_INLINE UInt64x4 in_order(const SampleBits &samples)
{
  const auto &bytes = reinterpret_cast<const UInt8x32 &>(samples);
  const UInt8x32 by_byte = __builtin_shufflevector(bytes, bytes, 0, 4, 8, 12, 16, 20, 24, 28, 1, 5, 9, 13, 17, 21, 25,
                                                   29, 2, 6, 10, 14, 18, 22, 26, 30, 3, 7, 11, 15, 19, 23, 27, 31);
  // Each word is a square of bits now, a byte per word of the samples, and is mirrored at its diagonal.
  auto squares = reinterpret_cast<const UInt64x4 &>(by_byte);
  UInt64x4 swapped = (squares ^ squares >> 7) & 0x00AA00AA00AA00AA;
  squares ^= swapped ^ swapped << 7;
  swapped = (squares ^ squares >> 14) & 0x0000CCCC0000CCCC;
  squares ^= swapped ^ swapped << 14;
  swapped = (squares ^ squares >> 28) & 0x00000000F0F0F0F0;
  return squares ^ swapped ^ swapped << 28;
}

/// Takes the patterns of a row's samples to the lists. Without a branch for each: they are few, but nowhere
/// foreseeable.
class PatternSorter {
public:
  PatternSorter(PatternList &deep, PatternList &meeting)
      : tables_(star_tables()), deep_(deep), meeting_(meeting), next_deep_(deep.found.data()),
        next_meeting_(meeting.found.data())
  {
  }

  VOLSURF_LANES_INLINE void add(const StarPattern &pattern)
  {
    const unsigned cells = newborn_cells(pattern.mask);
    const unsigned parts = tables_.parts_outside(cells, newborn_faces(pattern.mask));
    *next_deep_ = pattern;
    next_deep_ += tables_.deep[cells] != 0 ? 1 : 0;
    *next_meeting_ = pattern;
    next_meeting_ += (parts & (parts - 1)) != 0 ? 1 : 0;
  }

  void finish()
  {
    deep_.count = next_deep_ - deep_.begin();
    meeting_.count = next_meeting_ - meeting_.begin();
  }

private:
  const StarTables &tables_;
  PatternList &deep_;
  PatternList &meeting_;
  StarPattern *next_deep_;
  StarPattern *next_meeting_;
};

} // namespace

VOLSURF_VECTORISE
void find_patterns(NewbornRow newborn, std::int64_t y, std::int64_t z, const BorderRule &border, PatternList &deep,
                   PatternList &meeting)
{
  const std::int64_t count = border.samples()[0];
  const bool is_border_row = border.real_cells_in_row(y, z) != kAllOctants;
  const auto is_border = [&](std::int64_t x) { return is_border_row || x == 0 || x == count - 1; };
  PatternSorter sorter(deep, meeting);
  for (std::int64_t begin = 0; begin < count; begin += kBlockSamples) {
    const std::int64_t length = std::min(kBlockSamples, count - begin);
    PatternBits bits = bits_of_block(newborn, begin / kBlockSamples);
    SampleBits found = samples_with_deep_octant(bits) | samples_with_parts(bits);
    found |= is_border_row ? ~kNoSamples : kNoSamples; // whose patterns are not complete yet
    found |= begin == 0 ? sample_bit(0) : kNoSamples;
    found |= begin + length == count ? sample_bit(length - 1) : kNoSamples;
    for (int i = 0; i < 3; ++i)
      transpose(bits.bits + kLanes * i);
    const UInt64x4 words = in_order(found);
    for (std::int64_t word = 0; 64 * word < length; ++word)
      for (std::uint64_t rest = words[word]; rest != 0; rest &= rest - 1) {
        const std::int64_t sample = 64 * word + __builtin_ctzll(rest);
        if (sample >= length)
          break;
        const std::int64_t x = begin + sample;
        const unsigned real = is_border(x) ? border.real_cells(x, y, z) : kAllOctants;
        sorter.add({x, border.complete(pattern_of(bits, sample), real), real});
      }
  }
  sorter.finish();
}

} // namespace volsurf
