#include "volsurf/topology/delta_choice.h"

#include "support/fields.h"
#include "support/merge_of_field.h"

#include "volsurf/core/error.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

TEST(ParseDelta, IsAWordANumberOrAPercentage)
{
  for (const std::string text : {"auto", "20", "0.5", "10%", "100%", "1e-05"})
    EXPECT_EQ(delta_text(parse_delta(text)), "--delta " + text);
  for (const std::string text : {"", "0", "-1", "nan", "inf", "Auto", "5x", "0%", "101%", "-3%", "%", "5 %"})
    EXPECT_THROW(parse_delta(text), UsageError) << text;
}

TEST(ResolveDelta, AutomaticTakesTheFirstCandidate)
{
  DeltaCandidate best{1, 4, 1, 2, 0.01, 3};
  EXPECT_EQ(resolve_delta(AutomaticDelta{}, {}, {best, {}}), 2);
  EXPECT_EQ(resolve_delta(AutomaticDelta{}, {}, {}), 0);
}

RC_GTEST_PROP(ResolveDelta, PercentagesAreOfTheLargestPersistence, ())
{
  const Field field = *random_field();
  const Hierarchy hierarchy = merge_of(field, Exterior::none).hierarchy;
  const double percent = 0.5 * *rc::gen::inRange(1, 201);
  const double exact = percent / 100 * hierarchy.largest_persistence();
  const double delta = resolve_delta(DeltaPercent{percent}, hierarchy, {});
  RC_ASSERT(std::abs(delta - exact) <= 0.001 * exact);
  RC_ASSERT(delta <= hierarchy.largest_persistence()); // 100 % leaves two regions
}

RC_GTEST_PROP(ResolveDelta, RegionsLeavesSoManyOrWhereWallsTieTheNextNumber, ())
{
  const Field field = *random_field();
  const Hierarchy hierarchy = merge_of(field, *rc::gen::element(Exterior::none, Exterior::infinite)).hierarchy;
  const std::size_t most = hierarchy.region_count(std::numeric_limits<double>::denorm_min());
  for (std::size_t wanted = 2; wanted <= most; ++wanted) {
    const double delta = resolve_delta(DeltaRegions{static_cast<std::int64_t>(wanted)}, hierarchy, {});
    const std::size_t found = cut(hierarchy, delta).count();
    RC_ASSERT(found == hierarchy.region_count(delta));
    RC_ASSERT(found >= wanted);
    RC_ASSERT(hierarchy.region_count(std::nextafter(hierarchy.persistence[hierarchy.by_rank[wanted - 1]],
                                                    std::numeric_limits<float>::infinity())) < wanted);
    if (wanted == most ||
        hierarchy.persistence[hierarchy.by_rank[wanted]] < hierarchy.persistence[hierarchy.by_rank[wanted - 1]])
      RC_ASSERT(found == wanted);
  }
  RC_ASSERT_THROWS_AS(resolve_delta(DeltaRegions{static_cast<std::int64_t>(most) + 1}, hierarchy, {}), UsageError);
}
