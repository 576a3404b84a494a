#include "volsurf/topology/newborn.h"

#include "volsurf/core/vectorise.h"

#include <algorithm>

namespace volsurf {

namespace {

constexpr NewbornMask kNone = 0;
constexpr NewbornMask kAll = ~kNone;

/// All ones where the middle sample v comes before a neighbour of lower linear index, which wins ties.
inline NewbornMask before_lower(float v, float neighbour)
{
  return v > neighbour ? kAll : kNone;
}

/// The same for a neighbour of higher linear index.
inline NewbornMask before_higher(float v, float neighbour)
{
  return v >= neighbour ? kAll : kNone;
}

} // namespace

VOLSURF_VECTORISE
void newborn_masks(const StarRows &rows, std::int64_t count, NewbornMask *masks)
{
  const float *const r00 = rows[0]; // r<z><y>: 0 below, 1 level, 2 above
  const float *const r01 = rows[1];
  const float *const r02 = rows[2];
  const float *const r10 = rows[3];
  const float *const r11 = rows[4];
  const float *const r12 = rows[5];
  const float *const r20 = rows[6];
  const float *const r21 = rows[7];
  const float *const r22 = rows[8];
  for (std::int64_t x = 0; x < count; ++x) {
    const float v = r11[x];
    const NewbornMask xl = before_lower(v, r11[x - 1]);
    const NewbornMask xh = before_higher(v, r11[x + 1]);
    const NewbornMask yl = before_lower(v, r10[x]);
    const NewbornMask yh = before_higher(v, r12[x]);
    const NewbornMask zl = before_lower(v, r01[x]);
    const NewbornMask zh = before_higher(v, r21[x]);

    // A face is newborn if v comes before its other three corners; the suffix tells its sides, lower axis first.
    const NewbornMask x_ll = yl & zl & before_lower(v, r00[x]);
    const NewbornMask x_hl = yh & zl & before_lower(v, r02[x]);
    const NewbornMask x_lh = yl & zh & before_higher(v, r20[x]);
    const NewbornMask x_hh = yh & zh & before_higher(v, r22[x]);
    const NewbornMask y_ll = xl & zl & before_lower(v, r01[x - 1]);
    const NewbornMask y_hl = xh & zl & before_lower(v, r01[x + 1]);
    const NewbornMask y_lh = xl & zh & before_higher(v, r21[x - 1]);
    const NewbornMask y_hh = xh & zh & before_higher(v, r21[x + 1]);
    const NewbornMask z_ll = xl & yl & before_lower(v, r10[x - 1]);
    const NewbornMask z_hl = xh & yl & before_lower(v, r10[x + 1]);
    const NewbornMask z_lh = xl & yh & before_higher(v, r12[x - 1]);
    const NewbornMask z_hh = xh & yh & before_higher(v, r12[x + 1]);

    // A cell is newborn if its three faces at v are and v comes before the corner opposite to v.
    const NewbornMask c0 = x_ll & y_ll & z_ll & before_lower(v, r00[x - 1]);
    const NewbornMask c1 = x_ll & y_hl & z_hl & before_lower(v, r00[x + 1]);
    const NewbornMask c2 = x_hl & y_ll & z_lh & before_lower(v, r02[x - 1]);
    const NewbornMask c3 = x_hl & y_hl & z_hh & before_lower(v, r02[x + 1]);
    const NewbornMask c4 = x_lh & y_lh & z_ll & before_higher(v, r20[x - 1]);
    const NewbornMask c5 = x_lh & y_hh & z_hl & before_higher(v, r20[x + 1]);
    const NewbornMask c6 = x_hh & y_lh & z_lh & before_higher(v, r22[x - 1]);
    const NewbornMask c7 = x_hh & y_hh & z_hh & before_higher(v, r22[x + 1]);

    masks[x] = (c0 & 1U << 0) | (c1 & 1U << 1) | (c2 & 1U << 2) | (c3 & 1U << 3) | (c4 & 1U << 4) | (c5 & 1U << 5) |
               (c6 & 1U << 6) | (c7 & 1U << 7) | (x_ll & 1U << 8) | (x_hl & 1U << 9) | (x_lh & 1U << 10) |
               (x_hh & 1U << 11) | (y_ll & 1U << 12) | (y_hl & 1U << 13) | (y_lh & 1U << 14) | (y_hh & 1U << 15) |
               (z_ll & 1U << 16) | (z_hl & 1U << 17) | (z_lh & 1U << 18) | (z_hh & 1U << 19);
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
