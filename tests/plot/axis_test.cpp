#include "volsurf/plot/axis.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

using namespace volsurf::plot;

namespace {

std::vector<std::string> labels_of(const Axis &axis, int most_labels)
{
  std::vector<std::string> labels;
  for (const Tick &tick : ticks(axis, most_labels))
    if (!tick.label.empty())
      labels.push_back(tick.label);
  return labels;
}

Axis any_axis()
{
  Axis axis;
  axis.scale = *rc::gen::element(Scale::linear, Scale::logarithmic);
  axis.low = std::pow(10.0, 0.01 * *rc::gen::inRange(-500, 500));
  axis.high = axis.low * std::pow(10.0, 0.01 * *rc::gen::inRange(5, 800));
  return axis;
}

} // namespace

RC_GTEST_PROP(Axis, TicksLieWithinItAndAscend, ())
{
  const Axis axis = any_axis();
  const auto all = ticks(axis, *rc::gen::inRange(2, 20));
  for (const Tick &tick : all) {
    RC_ASSERT(position(axis, tick.value) > -1e-6);
    RC_ASSERT(position(axis, tick.value) < 1 + 1e-6);
  }
  RC_ASSERT(std::is_sorted(all.begin(), all.end(), [](const Tick &a, const Tick &b) { return a.value < b.value; }));
}

RC_GTEST_PROP(Axis, LabelsAreNotMoreThanThereIsRoomForAndDiffer, ())
{
  const Axis axis = any_axis();
  const int most = *rc::gen::inRange(4, 20);
  auto labels = labels_of(axis, most);
  RC_ASSERT(labels.size() <= static_cast<std::size_t>(most) + 1);
  std::sort(labels.begin(), labels.end());
  RC_ASSERT(std::adjacent_find(labels.begin(), labels.end()) == labels.end());
}

TEST(Axis, LogarithmicLabelsArePowersOfTenAndWhereTheseAreFewTwoAndFiveTimesThose)
{
  EXPECT_EQ(labels_of({"", Scale::logarithmic, 1, 1e4}, 5),
            (std::vector<std::string>{"1", "10", "100", "1,000", "10,000"}));
  EXPECT_EQ(labels_of({"", Scale::logarithmic, 0.05, 2}, 8),
            (std::vector<std::string>{"0.05", "0.1", "0.2", "0.5", "1", "2"}));
}

TEST(Axis, LinearLabelsAreRound)
{
  EXPECT_EQ(labels_of({"", Scale::linear, 0, 97}, 5), (std::vector<std::string>{"0", "20", "40", "60", "80"}));
}

TEST(Axis, PositionIsZeroAtLowAndOneAtHigh)
{
  for (const Scale scale : {Scale::linear, Scale::logarithmic}) {
    const Axis axis{"", scale, 2, 50};
    EXPECT_DOUBLE_EQ(position(axis, 2), 0);
    EXPECT_DOUBLE_EQ(position(axis, 50), 1);
  }
  EXPECT_DOUBLE_EQ(position({"", Scale::logarithmic, 1, 100}, 10), 0.5);
}
