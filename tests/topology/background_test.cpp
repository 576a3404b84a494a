#include "volsurf/topology/background.h"

#include "support/basin_trees.h"
#include "support/label_volumes.h"
#include "support/merge_of_field.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

/// The first of the `survivors` strongest basins on a basin's way up.
BasinId survivor_of(const Hierarchy &hierarchy, BasinId basin, std::size_t survivors)
{
  while (hierarchy.rank[basin] >= survivors)
    basin = hierarchy.ancestor[basin];
  return basin;
}

std::int64_t border_faces_of(const RegionMerge &merge, BasinId survivor, std::size_t survivors)
{
  std::int64_t faces = 0;
  for_each_sample(merge.cells.size, [&](const Index3 &p, CellId cell) {
    if (survivor_of(merge.hierarchy, merge.cells.basins[cell], survivors) == survivor)
      for (int axis = 0; axis < 3; ++axis)
        faces += (p[axis] == 0) + (p[axis] == merge.cells.size[axis] - 1);
  });
  return faces;
}

/// The faces of all basins whose survivor is the given one.
std::int64_t faces_of(const Hierarchy &hierarchy, const std::vector<std::int64_t> &border_faces, BasinId survivor,
                      std::size_t survivors)
{
  std::int64_t faces = 0;
  for (BasinId basin = 0; basin < border_faces.size(); ++basin)
    if (survivor_of(hierarchy, basin, survivors) == survivor)
      faces += border_faces[basin];
  return faces;
}

} // namespace

RC_GTEST_PROP(CountBorderFaces, CountsTheCapsOfEachBasin, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 5, 4);
  std::vector<std::int64_t> expected(labels.region_of_basin.size());
  for_each_sample(labels.cells.size, [&](const Index3 &p, CellId) {
    for (int axis = 0; axis < 3; ++axis)
      expected[labels.at(p)] += (p[axis] == 0) + (p[axis] == labels.cells.size[axis] - 1);
  });
  RC_ASSERT(count_border_faces(labels.cells, labels.region_of_basin.size()) == expected);
}

RC_GTEST_PROP(FindBackground, WhereABackgroundFallsApartThePartWithMoreBorderFacesRemains, ())
{
  const Field field = *random_field();
  const RegionMerge merge = merge_of(field, Exterior::none);
  const Hierarchy &hierarchy = merge.hierarchy;
  BasinId background = hierarchy.by_rank.front();
  for (std::size_t survivors = 2; survivors <= hierarchy.basin_count(); ++survivors) {
    const BasinId part = hierarchy.by_rank[survivors - 1];
    if (survivor_of(hierarchy, hierarchy.ancestor[part], survivors) == background &&
        border_faces_of(merge, part, survivors) > border_faces_of(merge, background, survivors))
      background = part;
    RC_ASSERT(survivor_of(hierarchy, hierarchy.background, survivors) == background);
  }
}

RC_GTEST_PROP(FindBackground, IsAsDefinedWhereFewBasinsAreAtTheBorder, ())
{
  Dice dice(*random_seed());
  const Hierarchy hierarchy = hierarchy_of(random_tree(static_cast<std::size_t>(dice.between(1, 40)), dice));
  std::vector<std::int64_t> border_faces(hierarchy.basin_count());
  for (std::int64_t &faces : border_faces)
    faces = dice.one_in(4) ? dice.between(1, 3) : 0;
  BasinId background = hierarchy.by_rank.front();
  for (std::size_t survivors = 2; survivors <= hierarchy.basin_count(); ++survivors) {
    const BasinId part = hierarchy.by_rank[survivors - 1];
    if (hierarchy.ancestor[part] == background &&
        faces_of(hierarchy, border_faces, part, survivors) > faces_of(hierarchy, border_faces, background, survivors))
      background = part;
  }
  RC_ASSERT(find_background(hierarchy, border_faces) == background);
}

RC_GTEST_PROP(FindBackground, IsTheExteriorsBasinWhereThereIsOne, ())
{
  const Field field = *random_field();
  const RegionMerge merge = merge_of(field, Exterior::infinite);
  RC_ASSERT(merge.hierarchy.exterior == merge.hierarchy.background);
}
