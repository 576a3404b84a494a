#include "volsurf/topology/elder_ancestors.h"

#include "volsurf/core/parallel.h"
#include "volsurf/core/radix_sort.h"

#include <algorithm>
#include <numeric>

namespace volsurf {

namespace {

/// Links lead up the tree, from elder sides to ancestors. Law: all basins that a link skips are of later rank than the
/// one that it is of. So threads need not know how far others are: any links lead to the same ancestors.
class Links {
public:
  explicit Links(std::vector<BasinId> &links) : links_(links) {}

  BasinId of(BasinId basin) const { return __atomic_load_n(&links_[basin], __ATOMIC_RELAXED); }
  void set(BasinId basin, BasinId link) { __atomic_store_n(&links_[basin], link, __ATOMIC_RELAXED); }

private:
  std::vector<BasinId> &links_;
};

/// In each pass, at the most and on the average: five are the rule in noise, but one way of many may be long.
constexpr std::int64_t kHopsPerBasin = 64;

/// Not a branch, even where the compiler likes those better: no one can tell which of the two it will be.
BasinId choose(bool first, BasinId a, BasinId b)
{
  return b ^ ((a ^ b) & -static_cast<BasinId>(first));
}

/// Links basins two links further up, unless one link leads to the ancestor, and those there one link further: path
/// splitting. Removes those that have arrived. A link of another slab's basin may be put back, to where it was before
/// that slab has found the ancestor.
void hop(std::vector<BasinId> &basins, const std::vector<std::uint32_t> &rank, Links links)
{
  std::size_t left = 0;
  for (const BasinId basin : basins) {
    const BasinId link = links.of(basin);
    const BasinId next = links.of(link);
    const bool goes_on = rank[link] > rank[basin];
    const bool splits = rank[next] > rank[link];
    const BasinId to = choose(splits, links.of(next), next);
    links.set(choose(splits, link, basin), choose(splits, to, link)); // where it splits nothing, what is there
    links.set(basin, choose(goes_on, to, link));
    basins[left] = basin;
    left += goes_on ? 1 : 0;
  }
  basins.resize(left);
}

/// Links the basins of a slab to their ancestors, but for what other slabs put back. Those of a batch in turns, so that
/// none waits for the memory that another one needs.
void climb(const Slab &slab, const std::vector<std::uint32_t> &rank, Links links)
{
  constexpr std::int64_t kBatch = 512;
  std::int64_t hops = kHopsPerBasin * (slab.end - slab.begin);
  std::vector<BasinId> basins;
  for (std::int64_t begin = slab.begin; begin < slab.end; begin += kBatch) {
    basins.resize(static_cast<std::size_t>(std::min(kBatch, slab.end - begin)));
    std::iota(basins.begin(), basins.end(), static_cast<BasinId>(begin));
    for (; !basins.empty() && hops > 0; hops -= static_cast<std::int64_t>(basins.size()))
      hop(basins, rank, links);
  }
}

/// Links what climb() has left to the ancestors. Returns the ranks of those for which it takes too many hops.
std::vector<std::uint32_t> climb_alone(const Slab &slab, const std::vector<std::uint32_t> &rank, Links links)
{
  std::int64_t hops = kHopsPerBasin * (slab.end - slab.begin);
  std::vector<std::uint32_t> left;
  for (auto basin = static_cast<BasinId>(slab.begin); basin < slab.end; ++basin) {
    BasinId link = links.of(basin);
    if (rank[link] <= rank[basin])
      continue;
    for (; rank[link] > rank[basin] && hops > 0; --hops)
      link = links.of(link);
    links.set(basin, link);
    if (rank[link] > rank[basin])
      left.push_back(rank[basin]);
  }
  return left;
}

/// From the last rank to the first, with the links as they are at first beside the ancestors: only ways through basins
/// of later rank than any that is still to come are made shorter.
void climb_by_rank(const std::vector<BasinId> &by_rank, const std::vector<std::uint32_t> &rank,
                   std::vector<std::uint32_t> ranks, std::vector<BasinId> &links)
{
  radix_sort(ranks, [](std::uint32_t r) { return ~r; });
  std::vector<BasinId> linked = links;
  for (const std::uint32_t r : ranks) {
    BasinId link = links[by_rank[r]];
    while (rank[link] > r) {
      BasinId &next = linked[link];
      if (rank[next] > r)
        next = linked[next];
      link = next;
    }
    links[by_rank[r]] = link;
    linked[by_rank[r]] = link;
  }
}

} // namespace

void find_elder_ancestors(const std::vector<BasinId> &by_rank, const std::vector<std::uint32_t> &rank,
                          std::vector<BasinId> &elder_side)
{
  const auto count = static_cast<std::int64_t>(elder_side.size());
  const std::int64_t basins_per_slab = large_slab(count); // ways within one are found once
  parallel_for_slabs(count, basins_per_slab, [&](const Slab &slab) { climb(slab, rank, Links(elder_side)); });
  std::vector<std::vector<std::uint32_t>> left(static_cast<std::size_t>(slab_count(count, basins_per_slab)));
  parallel_for_slabs(count, basins_per_slab, [&](const Slab &slab) {
    left[static_cast<std::size_t>(slab.index)] = climb_alone(slab, rank, Links(elder_side));
  });
  std::vector<std::uint32_t> ranks;
  for (const auto &of_slab : left)
    ranks.insert(ranks.end(), of_slab.begin(), of_slab.end());
  if (!ranks.empty())
    climb_by_rank(by_rank, rank, std::move(ranks), elder_side);
}

} // namespace volsurf
