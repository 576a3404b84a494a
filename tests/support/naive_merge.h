// The oracle: Kruskal over explicit faces in order K with two union-finds, as docs/method.md defines the region
// merge. It is slow on purpose: each definition stands in it as it is written.
#pragma once

#include "volsurf/topology/cubical_complex.h"

#include <cstdint>
#include <vector>

namespace volsurf::support {

/// A field on a small grid.
struct Field {
  Index3 size;
  std::vector<float> values; ///< I per sample, x fastest
};

/// An edge of the tree.
struct TreeEdge {
  std::int64_t face; ///< 3 * sample of its lowest corner + axis
  std::size_t a;     ///< nodes: cells by id; the exterior, if any, is the last node
  std::size_t b;
  float persistence;
};

/// A face with its place in the order K.
struct OrderedFace {
  std::int64_t face; ///< as in TreeEdge
  std::size_t a;
  std::size_t b;
  float value; ///< I(face)
};

/// All faces that join two nodes, in order K.
std::vector<OrderedFace> naive_order(const Field &field, Exterior exterior);

/// Per cell its first corner in the sample order, whose I is the cell's.
std::vector<SampleId> naive_max_vertices(const Field &field);

/// The edges of D1, in order K. With Exterior::infinite the nodes are the cells and one more.
std::vector<TreeEdge> naive_tree(const Field &field, Exterior exterior);

/// D2 at delta: for each node the smallest node of its region.
std::vector<std::size_t> naive_partition(const Field &field, Exterior exterior, float delta);

/// The same from a tree that is known already.
std::vector<std::size_t> naive_partition(const std::vector<TreeEdge> &tree, std::size_t nodes, float delta);

std::size_t node_count(const Field &field, Exterior exterior);

/// For each node the smallest node with the same label, so that partitions can be compared.
std::vector<std::size_t> canonical(const std::vector<std::uint32_t> &labels);

} // namespace volsurf::support
