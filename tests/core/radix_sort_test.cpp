#include "volsurf/core/radix_sort.h"

#include "support/fields.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

using namespace volsurf;
using namespace volsurf::support;

namespace {

struct Item {
  float key;
  std::size_t place;
};

bool operator==(const Item &a, const Item &b)
{
  return a.key == b.key && a.place == b.place;
}

/// Any number but NaN: often one of few, which ties, or one at an end.
float any_float(Dice &dice)
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

} // namespace

RC_GTEST_PROP(RadixSort, IsTheStableSortByDecreasingKey, ())
{
  Dice dice(*random_seed());
  std::vector<Item> items;
  for (auto count = static_cast<std::size_t>(dice.between(0, 300)); items.size() < count;)
    items.push_back({any_float(dice), items.size()});
  std::vector<Item> expected = items;
  std::stable_sort(expected.begin(), expected.end(), [](const Item &a, const Item &b) { return a.key > b.key; });
  radix_sort(items, [](const Item &item) { return descending_bits(item.key); });
  RC_ASSERT(items == expected);
}

RC_GTEST_PROP(RadixSort, BitsAscendExactlyWhereFloatsDescend, ())
{
  Dice dice(*random_seed());
  const float a = any_float(dice);
  const float b = any_float(dice);
  RC_ASSERT((a > b) == (descending_bits(a) < descending_bits(b)));
  RC_ASSERT((a == b) == (descending_bits(a) == descending_bits(b)));
}
