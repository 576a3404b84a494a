// Random trees of basins, which no field is needed for.
#pragma once

#include "support/fields.h"

#include "volsurf/topology/hierarchy.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace volsurf::support {

/// A tree of basins, with their persistences and numbers of cells.
struct TreeOfBasins {
  std::vector<BasinId> elder_side;
  std::vector<float> persistence;
  std::vector<std::int64_t> cell_counts;
};

enum class TreeShape { any, chain, near, bushes };
constexpr int kTreeShapes = 4;

enum class Persistences { distinct, levels, equal, rising, falling };
constexpr int kPersistences = 5;

/// A place further up in the tree, whose top is at 0.
inline std::int64_t place_above(TreeShape shape, std::int64_t place, Dice &dice)
{
  constexpr std::int64_t kBush = 16;
  switch (shape) {
  case TreeShape::chain:
    return place - 1;
  case TreeShape::near:
    return place - dice.between(1, std::min<std::int64_t>(place, 4));
  case TreeShape::bushes:
    return (place - 1) / kBush * kBush;
  default:
    return dice.between(0, place - 1);
  }
}

inline float persistence_at(Persistences kind, std::size_t place, Dice &dice)
{
  switch (kind) {
  case Persistences::levels:
    return static_cast<float>(dice.between(0, 3));
  case Persistences::equal:
    return 1;
  case Persistences::rising:
    return static_cast<float>(place);
  case Persistences::falling:
    return 1e6F - static_cast<float>(place);
  default:
    return static_cast<float>(dice.between(0, 1 << 20)) / 64.0F;
  }
}

/// The numbers of basins at 0 .. count-1 places: in order, in reverse, or in any order.
inline std::vector<BasinId> basins_at_places(std::size_t count, Dice &dice)
{
  std::vector<BasinId> basins(count);
  std::iota(basins.begin(), basins.end(), BasinId{0});
  if (dice.one_in(3))
    std::reverse(basins.begin(), basins.end());
  else if (dice.one_in(2))
    for (std::size_t i = count; i > 1; --i)
      std::swap(basins[i - 1], basins[static_cast<std::size_t>(dice.between(0, static_cast<std::int64_t>(i) - 1))]);
  return basins;
}

inline TreeOfBasins random_tree(std::size_t count, Dice &dice)
{
  const auto shape = static_cast<TreeShape>(dice.between(0, kTreeShapes - 1));
  const auto persistences = static_cast<Persistences>(dice.between(0, kPersistences - 1));
  const std::vector<BasinId> basin_at = basins_at_places(count, dice);
  TreeOfBasins tree{std::vector<BasinId>(count), std::vector<float>(count), {}};
  tree.elder_side[basin_at[0]] = basin_at[0];
  tree.persistence[basin_at[0]] = std::numeric_limits<float>::infinity();
  for (std::size_t place = 1; place < count; ++place) {
    tree.elder_side[basin_at[place]] =
        basin_at[static_cast<std::size_t>(place_above(shape, static_cast<std::int64_t>(place), dice))];
    tree.persistence[basin_at[place]] = persistence_at(persistences, place, dice);
  }
  while (tree.cell_counts.size() < count)
    tree.cell_counts.push_back(dice.one_in(2) ? 1 : dice.between(1, 9));
  return tree;
}

/// Half of the basins, at the end of a chain that gets stronger towards the top, are stronger than nearly all of it: no
/// way is like another's, and all are long.
inline TreeOfBasins tree_of_long_ways(std::size_t half)
{
  TreeOfBasins tree{{}, {}, std::vector<std::int64_t>(2 * half, 1)};
  for (std::size_t leaf = 0; leaf < half; ++leaf) {
    tree.elder_side.push_back(static_cast<BasinId>(half));
    tree.persistence.push_back(static_cast<float>(2 * half - 1 - leaf % 8));
  }
  for (std::size_t place = 0; place < half; ++place) {
    tree.elder_side.push_back(static_cast<BasinId>(std::min(half + place + 1, 2 * half - 1)));
    tree.persistence.push_back(static_cast<float>(half + place));
  }
  tree.persistence.back() = std::numeric_limits<float>::infinity();
  return tree;
}

inline Hierarchy hierarchy_of(const TreeOfBasins &tree)
{
  const std::size_t count = tree.elder_side.size();
  Basins basins{{}, std::vector<CellId>(count), std::vector<float>(count), tree.cell_counts};
  std::iota(basins.roots.begin(), basins.roots.end(), CellId{0});
  BasinTree basin_tree(count);
  basin_tree.elder_side = tree.elder_side;
  basin_tree.persistence = tree.persistence;
  return make_hierarchy(basins, basin_tree, Exterior::none);
}

} // namespace volsurf::support
