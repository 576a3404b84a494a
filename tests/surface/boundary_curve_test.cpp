// The curves against the naive way: at every delta that matters a cut, its boundary and its components.
#include "volsurf/surface/boundary_curve.h"

#include "support/fields.h"
#include "support/grids.h"
#include "support/merge_of_field.h"

#include "volsurf/core/parallel.h"
#include "volsurf/surface/boundary.h"
#include "volsurf/surface/components.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

using namespace volsurf;
using namespace volsurf::support;

namespace {

BasinRanks ranks_of(const Hierarchy &hierarchy)
{
  BasinRanks ranks;
  for (const BasinId basin : hierarchy.by_rank)
    ranks.persistence.push_back(hierarchy.persistence[basin]);
  ranks.background = hierarchy.background;
  ranks.joined_at = [&](BasinId a, BasinId b) { return joined_at_rank(hierarchy, a, b); };
  return ranks;
}

Grid grid_like(const Field &field)
{
  Dice dice(*random_seed());
  Grid grid = any_grid(dice);
  grid.size = field.size;
  return grid;
}

bool is_that_of_cuts(const BoundaryCurve &curve, const RegionMerge &merge, const Grid &grid)
{
  for (const float delta : deltas_that_matter(positive_persistences(merge.hierarchy))) {
    const Regions regions = cut(merge.hierarchy, delta);
    const FaceSet faces = find_boundary(merge.cells, {regions.of_basin, regions.of_basin[merge.hierarchy.background]});
    const Components components = find_components(faces, grid, {KeepAll{}, RankBy::area});
    const double area = std::accumulate(components.sizes.begin(), components.sizes.end(), 0.0);
    const bool same = curve.regions_at(delta) == regions.count() &&
                      curve.faces_at(delta) == static_cast<std::int64_t>(faces.size()) &&
                      curve.components_at(delta) == static_cast<std::int64_t>(components.count()) &&
                      std::abs(curve.area_at(delta) - area) <= 1e-9 * area;
    if (!same)
      return false;
  }
  return true;
}

} // namespace

RC_GTEST_PROP(BoundaryCurve, IsAtEveryDeltaThatOfTheCut, ())
{
  const Field field = *random_field();
  const RegionMerge merge = merge_of(field, *rc::gen::element(Exterior::none, Exterior::infinite));
  const Grid grid = grid_like(field);
  RC_ASSERT(is_that_of_cuts(find_boundary_curve(merge.cells, grid, ranks_of(merge.hierarchy)), merge, grid));
}

TEST(BoundaryCurve, OfMoreSlabsThanOneIsThatOfTheCutForAnyNumberOfThreads)
{
  Dice dice(7);
  Field field{{9, 70, 50}, {}};
  for_each_sample(field.size, [&](const Index3 &, SampleId) {
    field.values.push_back(-static_cast<float>(dice.between(0, 5) * dice.between(0, 5)));
  });
  const RegionMerge merge = merge_of(field, Exterior::none);
  Grid grid;
  grid.size = field.size;
  grid.spacing_mm = {0.5, 1, 2};
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    EXPECT_TRUE(is_that_of_cuts(find_boundary_curve(merge.cells, grid, ranks_of(merge.hierarchy)), merge, grid));
  }
}

RC_GTEST_PROP(BoundaryCurve, FallsAsDeltaGrows, ())
{
  const Field field = *random_field();
  const RegionMerge merge = merge_of(field, *rc::gen::element(Exterior::none, Exterior::infinite));
  const BoundaryCurve curve = find_boundary_curve(merge.cells, grid_like(field), ranks_of(merge.hierarchy));
  std::int64_t faces = std::numeric_limits<std::int64_t>::max();
  for (const float delta : deltas_that_matter(positive_persistences(merge.hierarchy))) {
    RC_ASSERT(curve.faces_at(delta) <= faces);
    faces = curve.faces_at(delta);
  }
  RC_ASSERT(faces == 0);
}

TEST(BoundaryCurve, CanBeInterrupted)
{
  const Field field = make_field(3, 6);
  const RegionMerge merge = merge_of(field, Exterior::none);
  Grid grid;
  grid.size = field.size;
  const auto stop = [](std::string_view, double) { return false; };
  EXPECT_THROW(find_boundary_curve(merge.cells, grid, ranks_of(merge.hierarchy), stop), Cancelled);
}
