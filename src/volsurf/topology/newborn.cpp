#include "volsurf/topology/newborn.h"

namespace volsurf {

namespace {

/// A block of a row.
struct BlockRows {
  /// Where the samples come before their neighbours at an offset.
  template <int Dx, int Dy, int Dz> VOLSURF_LANES_INLINE SampleBits before() const
  {
    constexpr int kNumber = neighbour_number(Dx, Dy, Dz);
    if constexpr (kNumber < kLowerNeighbours)
      return lanes_at<SampleBits>(rows.row + at + kLanes * kNumber);
    OrderRow neighbours = rows.row;
    if constexpr (Dz > 0)
      neighbours = rows.above[Dy + 1];
    else if constexpr (Dy > 0)
      neighbours = rows.next;
    neighbours += at + kLanes * (26 - kNumber);
    const SampleBits after = lanes_at<SampleBits>(neighbours); // where those neighbours come before the samples
    if constexpr (Dx > 0)
      return ~from_higher(after, is_last ? kNoSamples : lanes_at<SampleBits>(neighbours + kBlockWords));
    if constexpr (Dx < 0)
      return ~from_lower(after, is_first ? kNoSamples : lanes_at<SampleBits>(neighbours - kBlockWords));
    return ~after;
  }

  const StarRows &rows;
  std::int64_t at; // words before the block
  bool is_first;
  bool is_last;
};

/// By bit of the pattern.
struct NewbornBits {
  SampleBits of[kMaskBits];
};

VOLSURF_LANES_INLINE NewbornBits newborn_in_block(const BlockRows &v)
{
  const SampleBits xl = v.before<-1, 0, 0>();
  const SampleBits xh = v.before<1, 0, 0>();
  const SampleBits yl = v.before<0, -1, 0>();
  const SampleBits yh = v.before<0, 1, 0>();
  const SampleBits zl = v.before<0, 0, -1>();
  const SampleBits zh = v.before<0, 0, 1>();

  // A face is newborn if v comes before its other three corners; the suffix tells its sides, lower axis first.
  const SampleBits x_ll = yl & zl & v.before<0, -1, -1>();
  const SampleBits x_hl = yh & zl & v.before<0, 1, -1>();
  const SampleBits x_lh = yl & zh & v.before<0, -1, 1>();
  const SampleBits x_hh = yh & zh & v.before<0, 1, 1>();
  const SampleBits y_ll = xl & zl & v.before<-1, 0, -1>();
  const SampleBits y_hl = xh & zl & v.before<1, 0, -1>();
  const SampleBits y_lh = xl & zh & v.before<-1, 0, 1>();
  const SampleBits y_hh = xh & zh & v.before<1, 0, 1>();
  const SampleBits z_ll = xl & yl & v.before<-1, -1, 0>();
  const SampleBits z_hl = xh & yl & v.before<1, -1, 0>();
  const SampleBits z_lh = xl & yh & v.before<-1, 1, 0>();
  const SampleBits z_hh = xh & yh & v.before<1, 1, 0>();

  // A cell is newborn if its three faces at v are and v comes before the corner opposite to v.
  return {{x_ll & y_ll & z_ll & v.before<-1, -1, -1>(),
           x_ll & y_hl & z_hl & v.before<1, -1, -1>(),
           x_hl & y_ll & z_lh & v.before<-1, 1, -1>(),
           x_hl & y_hl & z_hh & v.before<1, 1, -1>(),
           x_lh & y_lh & z_ll & v.before<-1, -1, 1>(),
           x_lh & y_hh & z_hl & v.before<1, -1, 1>(),
           x_hh & y_lh & z_lh & v.before<-1, 1, 1>(),
           x_hh & y_hh & z_hh & v.before<1, 1, 1>(),
           x_ll,
           x_hl,
           x_lh,
           x_hh,
           y_ll,
           y_hl,
           y_lh,
           y_hh,
           z_ll,
           z_hl,
           z_lh,
           z_hh}};
}

constexpr unsigned kLowX = 0x55; // octants at the low side along x
constexpr unsigned kHighX = 0xAA;

} // namespace

VOLSURF_VECTORISE
void find_newborn(const StarRows &rows, std::int64_t y, std::int64_t z, const BorderRule &border,
                  std::uint32_t *newborn)
{
  const std::int64_t count = border.samples()[0];
  const unsigned real = border.real_cells_in_row(y, z);
  for (std::int64_t begin = 0; begin < count; begin += kBlockSamples, newborn += kNewbornWords) {
    const bool is_first = begin == 0;
    const bool is_last = begin + kBlockSamples >= count;
    NewbornBits bits = newborn_in_block({rows, begin / kBlockSamples * kBlockWords, is_first, is_last});
    for (int octant = 0; octant < kOctants; ++octant) {
      SampleBits outside = (real >> octant & 1U) != 0 ? kNoSamples : ~kNoSamples;
      outside |= is_first && (kLowX >> octant & 1U) != 0 ? sample_bit(0) : kNoSamples;
      outside |= is_last && (kHighX >> octant & 1U) != 0 ? sample_bit(count - 1 - begin) : kNoSamples;
      bits.of[octant] &= ~outside;
    }
    for (int i = 0; i < kMaskBits; ++i)
      lanes_at<SampleBits>(newborn + kLanes * i) = bits.of[i];
  }
}

BorderRule::BorderRule(const Index3 &samples, Exterior exterior) : samples_(samples)
{
  for (unsigned real = 0; real < 256; ++real) {
    NewbornMask missing = ~real & 0xFFU; // cells and faces outside, with `none` the border faces as well
    for (int f = 0; f < kStarFaces; ++f) {
      const int missing_sides = static_cast<int>((missing >> lower_octant(f) & 1U) + (missing >> upper_octant(f) & 1U));
      if (missing_sides == 2 || (missing_sides == 1 && exterior == Exterior::none))
        missing |= 1U << (8 + f);
    }
    keep_[real] = ~missing;
    set_[real] = exterior == Exterior::none ? missing : 0;
  }
}

} // namespace volsurf
