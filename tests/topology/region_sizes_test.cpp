#include "volsurf/topology/region_sizes.h"

#include "support/fields.h"
#include "support/merge_of_field.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

RC_GTEST_PROP(LargestRegionSizes, AreThoseOfTheCutAtEachBasinsPersistence, ())
{
  const Field field = *random_field();
  const RegionMerge merge = merge_of(field, *rc::gen::element(Exterior::none, Exterior::infinite));
  const Hierarchy &hierarchy = merge.hierarchy;
  const auto sizes = largest_region_sizes(hierarchy);
  for (BasinId basin = 0; basin < hierarchy.basin_count(); ++basin) {
    const double delta = hierarchy.persistence[basin];
    if (!(delta > 0))
      continue;
    const Regions regions = cut(hierarchy, delta);
    RC_ASSERT(sizes[basin] == regions.cell_counts[regions.of_basin[basin] - 1]);
  }
}

RC_GTEST_PROP(JoinedAtRank, IsTheMostSurvivorsThatLeaveTwoBasinsInOneRegion, ())
{
  const Field field = *random_field();
  const Hierarchy hierarchy = merge_of(field, *rc::gen::element(Exterior::none, Exterior::infinite)).hierarchy;
  for (const float delta : deltas_that_matter(positive_persistences(hierarchy))) {
    const Regions regions = cut(hierarchy, delta);
    for (BasinId a = 0; a < hierarchy.basin_count(); ++a)
      for (BasinId b = 0; b < hierarchy.basin_count(); b += 3)
        RC_ASSERT((regions.of_basin[a] == regions.of_basin[b]) == (regions.count() <= joined_at_rank(hierarchy, a, b)));
  }
}
