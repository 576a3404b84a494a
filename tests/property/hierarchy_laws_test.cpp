// One tree answers every delta: docs/method.md, T3, T4 and T6, and the numbers of regions.
#include "support/fields.h"
#include "support/merge_of_field.h"

#include "volsurf/surface/boundary.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <optional>

using namespace volsurf;
using namespace volsurf::support;

namespace {

Exterior either_exterior()
{
  return *rc::gen::element(Exterior::none, Exterior::infinite);
}

/// The basins on both sides of each face between two cells.
template <typename Visit> void for_each_inner_face(const CellLabels &cells, Visit visit)
{
  const CellGrid grid(cells.size);
  for_each_sample(cells.size, [&](const Index3 &p, CellId cell) {
    for (int axis = 0; axis < 3; ++axis)
      if (p[axis] > 0)
        visit(axis, p, cells.basins[cell + grid.offset(static_cast<Step>(2 * axis))], cells.basins[cell]);
  });
}

void require_one_maximum_per_region(const RegionMerge &merge, const Regions &regions, float delta)
{
  std::vector<BasinId> strong(regions.count(), static_cast<BasinId>(merge.hierarchy.basin_count()));
  for (BasinId basin = 0; basin < merge.hierarchy.basin_count(); ++basin) {
    const RegionId region = regions.of_basin[basin];
    const BasinId maximum = regions.maxima[region - 1];
    const float difference = merge.hierarchy.values[maximum] - merge.hierarchy.values[basin];
    RC_ASSERT(difference > 0 || (!(difference < 0) && maximum <= basin)); // ties: the earlier maximum
    RC_ASSERT((merge.hierarchy.persistence[basin] >= delta) == (basin == maximum));
  }
}

} // namespace

RC_GTEST_PROP(HierarchyLaws, T3PartitionsAreNested, ())
{
  const Field field = *random_field();
  const RegionMerge merge = merge_of(field, either_exterior());
  std::optional<Regions> finer;
  for (const float delta : deltas_that_matter(positive_persistences(merge.hierarchy))) {
    const Regions coarser = cut(merge.hierarchy, delta);
    std::vector<RegionId> holder(finer ? finer->count() + 1 : 0, kNoRegion);
    for (BasinId basin = 0; finer && basin < merge.hierarchy.basin_count(); ++basin) {
      RegionId &region = holder[finer->of_basin[basin]];
      RC_ASSERT(region == kNoRegion || region == coarser.of_basin[basin]);
      region = coarser.of_basin[basin];
    }
    finer = coarser;
  }
}

RC_GTEST_PROP(HierarchyLaws, T4EachRegionHoldsExactlyOneStrongBasinItsMaximum, ())
{
  const Field field = *random_field();
  const RegionMerge merge = merge_of(field, either_exterior());
  const auto persistences = positive_persistences(merge.hierarchy);
  for (const float delta : deltas_that_matter(persistences)) {
    const Regions regions = cut(merge.hierarchy, delta);
    const auto strong = std::count_if(persistences.begin(), persistences.end(), [&](float p) { return p >= delta; });
    RC_ASSERT(regions.count() == 1U + static_cast<std::size_t>(strong));
    require_one_maximum_per_region(merge, regions, delta);
  }
}

RC_GTEST_PROP(HierarchyLaws, RootsAreMaximaOfTheirBasins, ())
{
  const Field field = *random_field();
  const RegionMerge merge = merge_of(field, either_exterior());
  const auto max_vertex = naive_max_vertices(field);
  for (BasinId basin = 0; basin < merge.hierarchy.basin_count(); ++basin) {
    const CellId root = merge.hierarchy.roots[basin];
    RC_ASSERT((root < 0) == (merge.hierarchy.exterior == basin));
    if (root >= 0) {
      RC_ASSERT(merge.cells.basins[root] == basin);
      RC_ASSERT(merge.hierarchy.values[basin] == field.values[max_vertex[root]]);
    }
  }
  for (CellId cell = 0; cell < merge.cells.basins.size(); ++cell)
    RC_ASSERT(field.values[max_vertex[cell]] <= merge.hierarchy.values[merge.cells.basins[cell]]);
}

RC_GTEST_PROP(HierarchyLaws, T6FaceIsInTheBoundaryExactlyIfItsSaliencyReachesDelta, ())
{
  const Field field = *random_field();
  const RegionMerge merge = merge_of(field, either_exterior());
  for (const float delta : deltas_that_matter(positive_persistences(merge.hierarchy))) {
    const FaceSet faces = find_boundary(merge.cells, {cut(merge.hierarchy, delta).of_basin, 1});
    for_each_inner_face(merge.cells, [&](int axis, const Index3 &p, BasinId a, BasinId b) {
      RC_ASSERT(faces.contains(axis, p[0], p[1], p[2]) == (saliency(merge.hierarchy, a, b) >= delta));
      RC_ASSERT(saliency(merge.hierarchy, a, b) == saliency(merge.hierarchy, b, a));
    });
  }
}

RC_GTEST_PROP(HierarchyLaws, RegionsAreNumberedByDecreasingCellCountThenByTheirMaximum, ())
{
  const Field field = *random_field();
  const RegionMerge merge = merge_of(field, either_exterior());
  for (const float delta : deltas_that_matter(positive_persistences(merge.hierarchy))) {
    const Regions regions = cut(merge.hierarchy, delta);
    std::vector<std::int64_t> cells(regions.count());
    for (const BasinId basin : merge.cells.basins)
      ++cells[regions.of_basin[basin] - 1];
    RC_ASSERT(cells == regions.cell_counts);
    for (std::size_t i = 1; i < cells.size(); ++i)
      RC_ASSERT(cells[i - 1] > cells[i] || (cells[i - 1] == cells[i] && regions.maxima[i - 1] < regions.maxima[i]));
  }
}

// Two maxima of 3e38 over a floor of -3e38: the difference is no float.
TEST(HierarchyLaws, OnlyTheEldestBasinHasInfinitePersistence)
{
  Field field{{9, 2, 2}, std::vector<float>(36, -3e38F)};
  for (const std::size_t x : {0U, 8U})
    for (std::size_t row = 0; row < 4; ++row)
      field.values[x + 9 * row] = 3e38F;
  field.values[8] = 3.1e38F;
  const Hierarchy hierarchy = merge_of(field, Exterior::none).hierarchy;
  ASSERT_EQ(hierarchy.basin_count(), 2U);
  EXPECT_EQ(hierarchy.largest_persistence(), std::numeric_limits<float>::max());
  EXPECT_EQ(saliency(hierarchy, 0, 1), std::numeric_limits<float>::max());
}
