// What find_patterns() finds in a row of a volume, in types of the standard library.
#pragma once

#include "volsurf/topology/star_patterns.h"

#include <algorithm>
#include <utility>

namespace volsurf::support {

/// Samples and their patterns: those with deep octants, and those at which parts meet.
using RowPatterns = std::array<std::vector<std::pair<std::int64_t, std::uint32_t>>, 2>;

/// A volume with room around it for what comparisons read.
class PaddedField {
public:
  PaddedField(const std::array<std::int64_t, 3> &size, const std::vector<float> &values)
      : size_(size), values_(values.size() + 2 * kRoom)
  {
    std::copy(values.begin(), values.end(), values_.begin() + kRoom);
  }

  /// Rows outside the volume are the nearest ones.
  std::vector<std::uint32_t> order_of(std::int64_t y, std::int64_t z) const
  {
    std::vector<std::uint32_t> order(static_cast<std::size_t>(block_count(size_[0]) * kBlockWords));
    compare_with_lower(row(y, z), {row(y - 1, z), {row(y - 1, z - 1), row(y, z - 1), row(y + 1, z - 1)}}, size_[0],
                       order.data());
    return order;
  }

private:
  static constexpr std::int64_t kRoom = 8;

  const float *row(std::int64_t y, std::int64_t z) const
  {
    y = std::clamp<std::int64_t>(y, 0, size_[1] - 1);
    z = std::clamp<std::int64_t>(z, 0, size_[2] - 1);
    return values_.data() + kRoom + size_[0] * (y + size_[1] * z);
  }

  std::array<std::int64_t, 3> size_;
  std::vector<float> values_;
};

inline RowPatterns row_patterns(const PaddedField &field, const BorderRule &border, std::int64_t y, std::int64_t z)
{
  const auto row = field.order_of(y, z);
  const auto next = field.order_of(y + 1, z);
  const std::array<std::vector<std::uint32_t>, 3> above{field.order_of(y - 1, z + 1), field.order_of(y, z + 1),
                                                        field.order_of(y + 1, z + 1)};
  PatternList deep(border.samples()[0]);
  PatternList meeting(border.samples()[0]);
  std::vector<std::uint32_t> newborn(static_cast<std::size_t>(block_count(border.samples()[0]) * kNewbornWords));
  find_newborn({row.data(), next.data(), {above[0].data(), above[1].data(), above[2].data()}}, y, z, border,
               newborn.data());
  find_patterns(newborn.data(), y, z, border, deep, meeting);
  RowPatterns patterns;
  for (const StarPattern &pattern : deep)
    patterns[0].emplace_back(pattern.x, pattern.mask);
  for (const StarPattern &pattern : meeting)
    patterns[1].emplace_back(pattern.x, pattern.mask);
  return patterns;
}

} // namespace volsurf::support
