// What must not change the region merge, and the one way to see its other exterior.
#include "support/fields.h"
#include "support/merge_of_field.h"

#include "volsurf/core/parallel.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

Exterior either_exterior()
{
  return *rc::gen::element(Exterior::none, Exterior::infinite);
}

std::vector<BasinId> basins_of(const RegionMerge &merge)
{
  return {merge.cells.basins.begin(), merge.cells.basins.end()};
}

void require_same(const RegionMerge &a, const RegionMerge &b)
{
  RC_ASSERT(basins_of(a) == basins_of(b));
  RC_ASSERT(a.hierarchy.persistence == b.hierarchy.persistence);
  RC_ASSERT(a.hierarchy.ancestor == b.hierarchy.ancestor);
  RC_ASSERT(a.hierarchy.by_rank == b.hierarchy.by_rank);
  RC_ASSERT(a.hierarchy.rank == b.hierarchy.rank);
  RC_ASSERT(a.hierarchy.roots == b.hierarchy.roots);
  RC_ASSERT(a.hierarchy.values == b.hierarchy.values);
  RC_ASSERT(a.hierarchy.cell_counts == b.hierarchy.cell_counts);
  RC_ASSERT(a.hierarchy.exterior == b.hierarchy.exterior);
}

/// The field with a layer of samples of a value around it.
Field padded(const Field &field, float value)
{
  Field result{{field.size[0] + 2, field.size[1] + 2, field.size[2] + 2}, {}};
  for_each_sample(result.size, [&](const Index3 &p, SampleId) {
    bool ghost = false;
    for (int axis = 0; axis < 3; ++axis)
      ghost = ghost || p[axis] == 0 || p[axis] == result.size[axis] - 1;
    result.values.push_back(ghost ? value : field.values[sample_at(field, {p[0] - 1, p[1] - 1, p[2] - 1})]);
  });
  return result;
}

/// The partition of a padded field, as one of the cells of the field within and the exterior, which the ghost cells
/// stand for.
std::vector<std::size_t> partition_within(const RegionMerge &merge, float delta)
{
  const Regions regions = cut(merge.hierarchy, delta);
  std::vector<std::uint32_t> region;
  for_each_sample(merge.cells.size, [&](const Index3 &p, CellId cell) {
    bool ghost = false;
    for (int axis = 0; axis < 3; ++axis)
      ghost = ghost || p[axis] == 0 || p[axis] == merge.cells.size[axis] - 1;
    if (!ghost)
      region.push_back(regions.of_basin[merge.cells.basins[cell]]);
  });
  region.push_back(regions.of_basin[merge.cells.basins[0]]);
  return canonical(region);
}

} // namespace

RC_GTEST_PROP(RegionMerge, TilesAndThreadsDoNotChangeAnything, ())
{
  const Field field = *random_field(9);
  const Exterior exterior = either_exterior();
  const RegionMerge expected = merge_of(field, exterior, {field.size[2], field.size[1]});
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    for (std::int64_t planes = 1; planes < field.size[2]; ++planes)
      require_same(merge_of(field, exterior, {planes, threads}), expected);
  }
}

RC_GTEST_PROP(RegionMerge, InfiniteExteriorIsALayerOfHighGhostSamples, ())
{
  const Field field = *random_field();
  const Field with_ghosts = padded(field, 1e30F);
  const RegionMerge merge = merge_of(field, Exterior::infinite);
  const RegionMerge ghost_merge = merge_of(with_ghosts, Exterior::none);
  const auto persistences = positive_persistences(merge.hierarchy);
  RC_ASSERT(positive_persistences(ghost_merge.hierarchy) == persistences);
  for (const float delta : deltas_that_matter(persistences)) {
    if (delta < 1e29F)
      RC_ASSERT(partition_within(ghost_merge, delta) == partition_of(merge, delta));
  }
}
