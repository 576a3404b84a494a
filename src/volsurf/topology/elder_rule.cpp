#include "volsurf/topology/elder_rule.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace volsurf {

namespace {

/// Basins are numbered in the order of their maximal vertices, which breaks ties.
bool is_elder(const std::vector<float> &values, BasinId a, BasinId b)
{
  return values[a] > values[b] || (values[a] == values[b] && a < b);
}

/// The components of a block (D1 of the paper's algorithm 2). The representative is the eldest basin.
class BlockComponents {
public:
  BlockComponents(BasinBlock block, const BasinTree &tree)
      : basins_(block.basins), open_(std::move(block.open)), parent_(basins_.count())
  {
    for (BasinId i = 0; i < parent_.size(); ++i)
      parent_[i] = open_[i] != 0 ? i : tree.elder[basins_.begin + i] - basins_.begin;
  }

  bool contains(BasinId basin) const { return basins_.contains(basin); }

  /// Halves the path to the representative.
  BasinId find(BasinId basin)
  {
    BasinId i = basin - basins_.begin;
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return basins_.begin + i;
  }

  bool is_open(BasinId representative) const { return open_[representative - basins_.begin] != 0; }
  void set_open(BasinId representative) { open_[representative - basins_.begin] = 1; }
  void join(BasinId elder, BasinId younger) { parent_[younger - basins_.begin] = elder - basins_.begin; }

private:
  BasinRange basins_;
  std::vector<std::uint8_t> open_; // of representatives
  std::vector<BasinId> parent_;
};

} // namespace

BasinTree::BasinTree(std::size_t basins)
    : persistence(basins, std::numeric_limits<float>::infinity()), elder_side(basins), elder(basins)
{
  std::iota(elder_side.begin(), elder_side.end(), BasinId{0});
  elder = elder_side;
}

void join_basins(const std::vector<float> &values, BasinBlock block, std::vector<SaddleEdge> &edges, BasinTree &tree)
{
  BlockComponents components(std::move(block), tree);
  const auto is_done = [&](const SaddleEdge &edge) {
    if (!components.contains(edge.a) || !components.contains(edge.b)) {
      for (const BasinId basin : {edge.a, edge.b})
        if (components.contains(basin))
          components.set_open(components.find(basin));
      return false;
    }
    BasinId elder = components.find(edge.a);
    BasinId younger = components.find(edge.b);
    if (elder == younger)
      return true;
    BasinId side = edge.a;
    if (is_elder(values, younger, elder)) {
      std::swap(elder, younger);
      side = edge.b;
    }
    components.join(elder, younger);
    if (components.is_open(younger)) {
      components.set_open(elder);
      return false;
    }
    // An edge map of both signs may overflow, but only the eldest basin's persistence is infinite.
    tree.persistence[younger] = std::min(values[younger] - edge.value, std::numeric_limits<float>::max());
    tree.elder_side[younger] = side;
    tree.elder[younger] = elder;
    return true;
  };
  edges.erase(std::remove_if(edges.begin(), edges.end(), is_done), edges.end());
}

} // namespace volsurf
