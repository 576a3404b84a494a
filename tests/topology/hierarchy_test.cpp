// The hierarchy and its cut against their definitions, on trees that no field is needed for.
#include "volsurf/topology/hierarchy.h"

#include "volsurf/core/parallel.h"

#include "support/basin_trees.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

using namespace volsurf;
using namespace volsurf::support;

namespace {

bool ranks_are_those_of(const TreeOfBasins &tree, const Hierarchy &hierarchy)
{
  std::vector<BasinId> expected(tree.persistence.size());
  std::iota(expected.begin(), expected.end(), BasinId{0});
  std::stable_sort(expected.begin(), expected.end(),
                   [&](BasinId a, BasinId b) { return tree.persistence[a] > tree.persistence[b]; });
  for (std::uint32_t rank = 0; rank < expected.size(); ++rank)
    if (hierarchy.rank[expected[rank]] != rank)
      return false;
  return hierarchy.by_rank == expected;
}

std::vector<BasinId> plain_ancestors(const TreeOfBasins &tree, const std::vector<std::uint32_t> &rank)
{
  std::vector<BasinId> ancestors = tree.elder_side;
  for (BasinId basin = 0; basin < ancestors.size(); ++basin)
    while (rank[ancestors[basin]] > rank[basin])
      ancestors[basin] = tree.elder_side[ancestors[basin]];
  return ancestors;
}

/// Each basin is in the region of the first one on the way to the elder side that is strong enough.
Regions plain_cut(const TreeOfBasins &tree, double delta)
{
  std::vector<BasinId> maximum(tree.elder_side.size());
  std::vector<std::int64_t> cells(maximum.size());
  Regions regions;
  for (BasinId basin = 0; basin < maximum.size(); ++basin) {
    maximum[basin] = basin;
    while (!(tree.persistence[maximum[basin]] >= delta))
      maximum[basin] = tree.elder_side[maximum[basin]];
    cells[maximum[basin]] += tree.cell_counts[basin];
    if (maximum[basin] == basin)
      regions.maxima.push_back(basin);
  }
  std::stable_sort(regions.maxima.begin(), regions.maxima.end(),
                   [&](BasinId a, BasinId b) { return cells[a] > cells[b]; });
  std::vector<RegionId> region_of(maximum.size());
  for (const BasinId basin : regions.maxima) {
    regions.cell_counts.push_back(cells[basin]);
    region_of[basin] = static_cast<RegionId>(regions.cell_counts.size());
  }
  for (const BasinId basin : maximum)
    regions.of_basin.push_back(region_of[basin]);
  return regions;
}

bool operator==(const Regions &a, const Regions &b)
{
  return a.of_basin == b.of_basin && a.maxima == b.maxima && a.cell_counts == b.cell_counts;
}

/// Whether each number of threads finds the ranks, the ancestors and the regions that the definitions say.
bool is_as_defined(const TreeOfBasins &tree, double delta)
{
  const std::vector<BasinId> ancestors = plain_ancestors(tree, hierarchy_of(tree).rank);
  const Regions regions = plain_cut(tree, delta);
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    const Hierarchy hierarchy = hierarchy_of(tree);
    if (!ranks_are_those_of(tree, hierarchy) || hierarchy.ancestor != ancestors || !(cut(hierarchy, delta) == regions))
      return false;
  }
  return true;
}

} // namespace

RC_GTEST_PROP(Hierarchy, IsAsDefinedOnAnyTree, ())
{
  Dice dice(*random_seed());
  const TreeOfBasins tree = random_tree(static_cast<std::size_t>(dice.between(1, 200)), dice);
  const float delta = tree.persistence[static_cast<std::size_t>(
      dice.between(0, static_cast<std::int64_t>(tree.persistence.size()) - 1))];
  RC_ASSERT(is_as_defined(tree, std::max(delta, std::numeric_limits<float>::denorm_min())));
}

TEST(Hierarchy, IsAsDefinedWhereTreesAreLarge)
{
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Dice dice(seed);
    const TreeOfBasins tree = random_tree(20000, dice);
    EXPECT_TRUE(is_as_defined(tree, std::max(tree.persistence[10000], 1.0F))) << "seed " << seed;
  }
}

TEST(Hierarchy, IsAsDefinedWhereNoWayIsShort)
{
  const TreeOfBasins tree = tree_of_long_ways(4000);
  EXPECT_TRUE(is_as_defined(tree, 7990));
  EXPECT_TRUE(is_as_defined(tree, 4100));
}

TEST(Hierarchy, OneBasinIsItsOwnAncestor)
{
  const TreeOfBasins tree{{0}, {std::numeric_limits<float>::infinity()}, {3}};
  EXPECT_TRUE(is_as_defined(tree, 1));
  EXPECT_EQ(hierarchy_of(tree).ancestor, std::vector<BasinId>{0});
}
