#include "volsurf/topology/hierarchy.h"

#include "volsurf/core/radix_sort.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace volsurf {

namespace {

std::vector<BasinId> sort_by_persistence(const std::vector<float> &persistence)
{
  struct Ranked { // with its key, so that no pass of the sort looks for it all over memory
    std::uint32_t key;
    BasinId basin;
  };
  std::vector<Ranked> basins(persistence.size());
  for (BasinId basin = 0; basin < basins.size(); ++basin)
    basins[basin] = {descending_bits(persistence[basin]), basin};
  radix_sort(basins, [](const Ranked &ranked) { return ranked.key; });
  std::vector<BasinId> by_rank(basins.size());
  std::transform(basins.begin(), basins.end(), by_rank.begin(), [](const Ranked &ranked) { return ranked.basin; });
  return by_rank;
}

/// From the last rank to the first: a basin's way to the elder side, past all those of later rank, which are linked to
/// their ancestors by then. Puts the ancestors in place of the elder sides. `linked` is memory at hand: new memory
/// takes long.
void find_elder_ancestors(std::vector<BasinId> &elder_side, const std::vector<BasinId> &by_rank,
                          std::vector<BasinId> linked)
{
  std::iota(linked.begin(), linked.end(), BasinId{0});
  const auto find = [&](BasinId basin) {
    while (linked[basin] != basin) {
      linked[basin] = linked[linked[basin]];
      basin = linked[basin];
    }
    return basin;
  };
  constexpr std::size_t kAhead = 16; // basins of neighbouring ranks are anywhere in memory
  for (std::size_t rank = by_rank.size(); rank-- > 0;) {
    if (rank >= 2 * kAhead) {
      __builtin_prefetch(&elder_side[by_rank[rank - 2 * kAhead]]);
      __builtin_prefetch(&linked[elder_side[by_rank[rank - kAhead]]]);
    }
    const BasinId basin = by_rank[rank];
    BasinId &ancestor = elder_side[basin];
    ancestor = find(ancestor);
    linked[basin] = ancestor;
  }
}

constexpr std::uint32_t kUnknown = std::numeric_limits<std::uint32_t>::max();

/// The rank of the one basin in the region of each that survives: the survivors are the first ranks, and each other
/// basin is in the region of its ancestor.
std::vector<std::uint32_t> find_survivors(const Hierarchy &hierarchy, std::size_t survivors)
{
  std::vector<std::uint32_t> survivor(hierarchy.basin_count(), kUnknown);
  for (std::uint32_t rank = 0; rank < survivors; ++rank)
    survivor[hierarchy.by_rank[rank]] = rank;
  for (BasinId basin = 0; basin < survivor.size(); ++basin) {
    BasinId last = basin;
    while (survivor[last] == kUnknown)
      last = hierarchy.ancestor[last];
    for (BasinId passed = basin; passed != last; passed = hierarchy.ancestor[passed])
      survivor[passed] = survivor[last];
  }
  return survivor;
}

} // namespace

Hierarchy make_hierarchy(Basins &basins, BasinTree &tree, Exterior exterior)
{
  Hierarchy hierarchy;
  hierarchy.roots = std::move(basins.roots);
  hierarchy.values = std::move(basins.values);
  hierarchy.cell_counts = std::move(basins.cell_counts);
  if (exterior == Exterior::infinite)
    hierarchy.exterior = static_cast<BasinId>(hierarchy.roots.size() - 1);
  hierarchy.persistence = std::move(tree.persistence);
  hierarchy.by_rank = sort_by_persistence(hierarchy.persistence);
  hierarchy.rank.resize(hierarchy.by_rank.size());
  for (std::uint32_t rank = 0; rank < hierarchy.by_rank.size(); ++rank)
    hierarchy.rank[hierarchy.by_rank[rank]] = rank;
  find_elder_ancestors(tree.elder_side, hierarchy.by_rank, std::move(tree.elder));
  hierarchy.ancestor = std::move(tree.elder_side);
  return hierarchy;
}

std::size_t Hierarchy::region_count(double delta) const
{
  const auto first_merged =
      std::partition_point(by_rank.begin(), by_rank.end(), [&](BasinId basin) { return persistence[basin] >= delta; });
  return static_cast<std::size_t>(first_merged - by_rank.begin());
}

Regions cut(const Hierarchy &hierarchy, double delta)
{
  Regions regions;
  std::vector<std::uint32_t> &of_basin = regions.of_basin; // the rank of its survivor first, its region in the end
  of_basin = find_survivors(hierarchy, hierarchy.region_count(delta));
  std::vector<std::int64_t> cells(hierarchy.region_count(delta));
  for (BasinId basin = 0; basin < of_basin.size(); ++basin)
    cells[of_basin[basin]] += hierarchy.cell_counts[basin];

  std::vector<std::uint32_t> order(cells.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return cells[a] != cells[b] ? cells[a] > cells[b] : hierarchy.by_rank[a] < hierarchy.by_rank[b];
  });

  std::vector<RegionId> id(cells.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    id[order[i]] = static_cast<RegionId>(i + 1);
    regions.maxima.push_back(hierarchy.by_rank[order[i]]);
    regions.cell_counts.push_back(cells[order[i]]);
  }
  for (std::uint32_t &region : of_basin)
    region = id[region];
  return regions;
}

std::uint32_t joined_at_rank(const Hierarchy &hierarchy, BasinId a, BasinId b)
{
  auto earliest = static_cast<std::uint32_t>(hierarchy.basin_count());
  while (a != b) {
    BasinId &younger = hierarchy.rank[a] > hierarchy.rank[b] ? a : b;
    earliest = hierarchy.rank[younger];
    younger = hierarchy.ancestor[younger];
  }
  return earliest;
}

float saliency(const Hierarchy &hierarchy, BasinId a, BasinId b)
{
  return a == b ? 0.0F : hierarchy.persistence[hierarchy.by_rank[joined_at_rank(hierarchy, a, b)]];
}

} // namespace volsurf
