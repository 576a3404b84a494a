// Floats at which an order may fail.
#pragma once

#include "support/fields.h"

#include <array>
#include <cstring>
#include <limits>

namespace volsurf::support {

/// Any number but NaN: often one of few, which ties, or one at an end.
inline float any_float(Dice &dice)
{
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr std::array<float, 8> kSpecial{
      0.0F,      -0.0F,      std::numeric_limits<float>::denorm_min(), -std::numeric_limits<float>::denorm_min(),
      kInfinity, -kInfinity, std::numeric_limits<float>::max(),        std::numeric_limits<float>::lowest()};
  if (dice.one_in(3))
    return kSpecial[static_cast<std::size_t>(dice.between(0, 7))];
  if (dice.one_in(2))
    return static_cast<float>(dice.between(-3, 3));
  const auto bits = static_cast<std::uint32_t>(dice.between(0, 0xFFFFFFFF));
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value == value ? value : 0.0F;
}

} // namespace volsurf::support
