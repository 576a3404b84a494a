#include "volsurf/topology/region_merge.h"

#include "support/fields.h"
#include "support/merge_of_field.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <set>

using namespace volsurf;
using namespace volsurf::support;

namespace {

Exterior either_exterior()
{
  return *rc::gen::element(Exterior::none, Exterior::infinite);
}

/// Each delta at which the partition may change, and the ends.
std::vector<float> deltas_that_matter(const std::vector<TreeEdge> &tree)
{
  std::set<float> deltas{std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max()};
  for (const TreeEdge &edge : tree)
    if (edge.persistence > 0) {
      deltas.insert(edge.persistence);
      deltas.insert(std::nextafter(edge.persistence, std::numeric_limits<float>::infinity()));
    }
  return {deltas.begin(), deltas.end()};
}

std::multiset<float> positive(const std::vector<TreeEdge> &tree)
{
  std::multiset<float> result;
  for (const TreeEdge &edge : tree)
    if (edge.persistence > 0)
      result.insert(edge.persistence);
  return result;
}

} // namespace

RC_GTEST_PROP(RegionMerge, PartitionIsKruskalsForEveryDelta, ())
{
  const Field field = *random_field();
  const Exterior exterior = either_exterior();
  const auto tree = naive_tree(field, exterior);
  const RegionMerge merge = merge_of(field, exterior, *rc::gen::inRange<std::int64_t>(1, 5));
  for (const float delta : deltas_that_matter(tree))
    RC_ASSERT(partition_of(merge, delta) == naive_partition(tree, node_count(field, exterior), delta));
}

RC_GTEST_PROP(RegionMerge, PositivePersistencesAreKruskals, ())
{
  const Field field = *random_field();
  const Exterior exterior = either_exterior();
  const RegionMerge merge = merge_of(field, exterior, 2);
  std::multiset<float> finite;
  for (const float persistence : merge.hierarchy.persistence)
    if (persistence > 0 && std::isfinite(persistence))
      finite.insert(persistence);
  RC_ASSERT(finite == positive(naive_tree(field, exterior)));
}
