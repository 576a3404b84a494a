#include "volsurf/core/descending_order.h"

#include "volsurf/core/parallel.h"

#include "support/any_float.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

using namespace volsurf;
using namespace volsurf::support;

namespace {

bool is_stable_descending_order(const std::vector<float> &values)
{
  std::vector<std::uint32_t> expected(values.size());
  std::iota(expected.begin(), expected.end(), 0U);
  std::stable_sort(expected.begin(), expected.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return values[a] > values[b]; });
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    std::vector<std::uint32_t> memory{5};
    if (descending_order(values, memory) != expected)
      return false;
  }
  return true;
}

} // namespace

RC_GTEST_PROP(DescendingOrder, IsStable, ())
{
  Dice dice(*random_seed());
  std::vector<float> values(static_cast<std::size_t>(dice.between(0, 300)));
  std::generate(values.begin(), values.end(), [&] { return any_float(dice); });
  RC_ASSERT(is_stable_descending_order(values));
}

TEST(DescendingOrder, IsStableWhereManySlabsShareBuckets)
{
  Dice dice(1);
  std::vector<float> values(300000);
  std::generate(values.begin(), values.end(), [&] { return any_float(dice); });
  EXPECT_TRUE(is_stable_descending_order(values));
  std::generate(values.begin(), values.end(), [&] { return 1.0F + 1e-4F * static_cast<float>(dice.between(0, 99)); });
  EXPECT_TRUE(is_stable_descending_order(values));
  std::fill(values.begin(), values.end(), 1.0F);
  EXPECT_TRUE(is_stable_descending_order(values));
}
