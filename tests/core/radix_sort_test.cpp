#include "volsurf/core/radix_sort.h"

#include "support/any_float.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

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
