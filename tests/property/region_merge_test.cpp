#include "volsurf/topology/region_merge.h"

#include "support/fields.h"
#include "support/merge_of_field.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

Exterior either_exterior()
{
  return *rc::gen::element(Exterior::none, Exterior::infinite);
}

} // namespace

RC_GTEST_PROP(RegionMerge, PartitionIsKruskalsForEveryDelta, ())
{
  const Field field = *random_field();
  const Exterior exterior = either_exterior();
  const auto tree = naive_tree(field, exterior);
  const TileSize tile{*rc::gen::inRange<std::int64_t>(1, 5), *rc::gen::inRange<std::int64_t>(1, 5)};
  const RegionMerge merge = merge_of(field, exterior, tile);
  for (const float delta : deltas_that_matter(positive_persistences(tree)))
    RC_ASSERT(partition_of(merge, delta) == naive_partition(tree, node_count(field, exterior), delta));
}

RC_GTEST_PROP(RegionMerge, PositivePersistencesAreKruskals, ())
{
  const Field field = *random_field();
  const Exterior exterior = either_exterior();
  RC_ASSERT(positive_persistences(merge_of(field, exterior).hierarchy) ==
            positive_persistences(naive_tree(field, exterior)));
}
