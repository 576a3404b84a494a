#include "volsurf/topology/elder_rule.h"

#include "support/fields.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr std::size_t kParts = 4;

/// An edge, and the part that it is in.
struct PartEdge {
  SaddleEdge edge;
  std::size_t part;
};

/// Basins, and edges between them in the order K. Those of equal value follow each other by part, as planes do.
struct Graph {
  std::vector<float> values;
  std::vector<PartEdge> edges;
};

Graph random_graph(Dice &dice)
{
  Graph graph;
  const std::int64_t basins = dice.between(1, 40);
  for (std::int64_t i = 0; i < basins; ++i)
    graph.values.push_back(static_cast<float>(dice.between(0, 9)));
  for (std::int64_t i = dice.between(0, 120); i > 0; --i) {
    const auto a = static_cast<BasinId>(dice.between(0, basins - 1));
    const auto b = static_cast<BasinId>(dice.between(0, basins - 1));
    const float highest = std::min(graph.values[a], graph.values[b]);
    // Most basins have all their edges in one part.
    const std::size_t part = dice.one_in(8) ? static_cast<std::size_t>(dice.between(0, kParts - 1))
                                            : kParts * std::min(a, b) / graph.values.size();
    if (a != b)
      graph.edges.push_back({{highest - static_cast<float>(dice.between(0, 5)), a, b}, part});
  }
  std::stable_sort(graph.edges.begin(), graph.edges.end(), [](const PartEdge &left, const PartEdge &right) {
    return left.edge.value != right.edge.value ? left.edge.value > right.edge.value : left.part < right.part;
  });
  return graph;
}

/// The edges of parts first .. last, and which basins have others.
struct Block {
  std::vector<SaddleEdge> edges;
  BasinBlock basins;
};

Block block_of(const Graph &graph, std::size_t first, std::size_t last)
{
  Block block{{}, {{0, static_cast<BasinId>(graph.values.size())}, std::vector<std::uint8_t>(graph.values.size())}};
  for (const auto &[edge, part] : graph.edges)
    if (part >= first && part <= last)
      block.edges.push_back(edge);
    else
      block.basins.open[edge.a] = block.basins.open[edge.b] = 1;
  return block;
}

/// Leaves out the first basins, as long as they are open.
void forget_open_basins(Dice &dice, BasinBlock &block)
{
  while (block.basins.count() > 1 && block.open.front() == 1 && !dice.one_in(3)) {
    block.open.erase(block.open.begin());
    ++block.basins.begin;
  }
}

/// Adds what is left of a block to what is left of those before it, and sorts again.
void add_edges(const std::vector<SaddleEdge> &more, std::vector<SaddleEdge> &edges)
{
  edges.insert(edges.end(), more.begin(), more.end());
  std::stable_sort(edges.begin(), edges.end(),
                   [](const SaddleEdge &a, const SaddleEdge &b) { return a.value > b.value; });
}

} // namespace

RC_GTEST_PROP(ElderRule, BlocksOfBlocksGiveTheTreeOfAllEdgesAtOnce, ())
{
  Dice dice(*random_seed());
  const Graph graph = random_graph(dice);
  Block all = block_of(graph, 0, kParts - 1);
  BasinTree expected(graph.values.size());
  join_basins(graph.values, all.basins, all.edges, expected);
  RC_ASSERT(all.edges.empty());

  BasinTree tree(graph.values.size());
  std::vector<SaddleEdge> left;
  for (const std::size_t half : {std::size_t{0}, kParts / 2}) {
    std::vector<SaddleEdge> left_of_half;
    for (const std::size_t part : {half, half + 1}) {
      Block block = block_of(graph, part, part);
      forget_open_basins(dice, block.basins);
      join_basins(graph.values, block.basins, block.edges, tree);
      add_edges(block.edges, left_of_half);
    }
    join_basins(graph.values, block_of(graph, half, half + 1).basins, left_of_half, tree);
    add_edges(left_of_half, left);
  }
  join_basins(graph.values, all.basins, left, tree);
  RC_ASSERT(left.empty());
  RC_ASSERT(tree.persistence == expected.persistence);
  RC_ASSERT(tree.elder_side == expected.elder_side);
}
