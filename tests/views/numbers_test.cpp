#include "volsurf/views/numbers.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

using namespace volsurf::views;

TEST(Numbers, SignificantDigitsAreKeptWithoutExponentsOrTrailingZeros)
{
  EXPECT_EQ(significant(14.1584, 4), "14.16");
  EXPECT_EQ(significant(0.02, 4), "0.02");
  EXPECT_EQ(significant(250741, 3), "251000");
  EXPECT_EQ(significant(9.996, 3), "10");
  EXPECT_EQ(significant(0, 3), "0");
  EXPECT_EQ(significant(-32.5, 3), "-32.5");
  EXPECT_EQ(significant(std::numeric_limits<double>::infinity(), 3), "any");
}

RC_GTEST_PROP(Numbers, SignificantBelowIsNeverMoreAndHardlyLess, ())
{
  const double value = std::pow(10.0, 1e-4 * *rc::gen::inRange(-40000, 60000));
  const double shown = std::stod(significant_below(value, 4));
  RC_ASSERT(shown <= value);
  RC_ASSERT(shown > value * (1 - 1.01e-3));
}

TEST(Numbers, GroupsHaveThreeDigits)
{
  EXPECT_EQ(grouped(7), "7");
  EXPECT_EQ(grouped(1234567), "1\u202F234\u202F567");
  EXPECT_EQ(grouped(-123456), "-123\u202F456");
}
