#include "volsurf/topology/hierarchy.h"

#include "volsurf/core/descending_order.h"
#include "volsurf/core/parallel.h"
#include "volsurf/topology/elder_ancestors.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace volsurf {

namespace {

constexpr std::int64_t kBasinsPerSlab = 1 << 14;

/// Puts the inverse of by_rank into `rank`.
void invert(const std::vector<BasinId> &by_rank, std::vector<std::uint32_t> &rank)
{
  parallel_for_slabs(static_cast<std::int64_t>(by_rank.size()), kBasinsPerSlab, [&](const Slab &ranks) {
    for (std::int64_t i = ranks.begin; i < ranks.end; ++i)
      rank[by_rank[i]] = static_cast<std::uint32_t>(i);
  });
}

constexpr std::uint32_t kUnknown = std::numeric_limits<std::uint32_t>::max();

/// Adds to the cells of regions, as other threads do: those of the first ones, few of which have nearly all cells, at
/// once.
class RegionCells {
public:
  explicit RegionCells(std::vector<std::int64_t> &cells) : cells_(cells) {}
  RegionCells(const RegionCells &) = delete;
  RegionCells &operator=(const RegionCells &) = delete;
  ~RegionCells()
  {
    for (std::uint32_t region = 0; region < std::min(first_.size(), cells_.size()); ++region)
      if (first_[region] > 0)
        put_down(region, first_[region]);
  }

  void add(std::uint32_t region, std::int64_t cells)
  {
    if (region < first_.size())
      first_[region] += cells;
    else
      put_down(region, cells);
  }

private:
  void put_down(std::uint32_t region, std::int64_t cells)
  {
    __atomic_fetch_add(&cells_[region], cells, __ATOMIC_RELAXED);
  }

  std::array<std::int64_t, 256> first_{};
  std::vector<std::int64_t> &cells_;
};

/// The rank of the one basin in the region of `basin` that survives, found by the ancestors up to one of known
/// survivor. It gets known for all on the way. Other threads may do the same: they find the same.
std::uint32_t find_survivor(const Hierarchy &hierarchy, BasinId basin, std::vector<std::uint32_t> &survivors)
{
  const auto survivor_of = [&](BasinId b) { return __atomic_load_n(&survivors[b], __ATOMIC_RELAXED); };
  BasinId last = basin;
  std::uint32_t survivor = survivor_of(last);
  while (survivor == kUnknown) {
    last = hierarchy.ancestor[last];
    survivor = survivor_of(last);
  }
  for (BasinId passed = basin; passed != last; passed = hierarchy.ancestor[passed])
    __atomic_store_n(&survivors[passed], survivor, __ATOMIC_RELAXED);
  return survivor;
}

/// Per basin the rank of the one in its region that survives, and the regions' cells by that rank: the survivors are
/// the first ranks, and each other basin is in the region of its ancestor.
std::vector<std::uint32_t> find_survivors(const Hierarchy &hierarchy, std::vector<std::int64_t> &cells)
{
  std::vector<std::uint32_t> survivors(hierarchy.basin_count(), kUnknown);
  for (std::uint32_t rank = 0; rank < cells.size(); ++rank)
    survivors[hierarchy.by_rank[rank]] = rank;
  parallel_for_slabs(static_cast<std::int64_t>(survivors.size()), kBasinsPerSlab, [&](const Slab &slab) {
    RegionCells sums(cells);
    for (auto basin = static_cast<BasinId>(slab.begin); basin < slab.end; ++basin)
      sums.add(find_survivor(hierarchy, basin, survivors), hierarchy.cell_counts[basin]);
  });
  return survivors;
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
  hierarchy.by_rank = descending_order(hierarchy.persistence, tree.elder);
  hierarchy.rank = std::move(tree.elder); // memory at hand: new memory takes long
  invert(hierarchy.by_rank, hierarchy.rank);
  find_elder_ancestors(hierarchy.by_rank, hierarchy.rank, tree.elder_side);
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
  std::vector<std::int64_t> cells(hierarchy.region_count(delta));
  of_basin = find_survivors(hierarchy, cells);

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
  parallel_for_slabs(static_cast<std::int64_t>(of_basin.size()), kBasinsPerSlab, [&](const Slab &slab) {
    for (std::int64_t basin = slab.begin; basin < slab.end; ++basin)
      of_basin[basin] = id[of_basin[basin]];
  });
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
