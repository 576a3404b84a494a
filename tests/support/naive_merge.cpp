#include "support/naive_merge.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

namespace volsurf::support {

namespace {

using Nodes = std::vector<std::size_t>;

struct Face {
  int axis;
  SampleId lowest_corner;
  std::size_t a; // its two nodes
  std::size_t b;
  SampleId max_vertex;
  int layer;
  float steepest;
};

/// All of the complex, spelled out.
struct Complex {
  const Field &field;
  Index3 size;
  Index3 cells;
  Exterior exterior;

  Complex(const Field &f, Exterior e)
      : field(f), size(f.size), cells{f.size[0] - 1, f.size[1] - 1, f.size[2] - 1}, exterior(e)
  {
  }

  std::size_t exterior_node() const { return static_cast<std::size_t>(cells[0] * cells[1] * cells[2]); }

  SampleId sample(const Index3 &p) const { return p[0] + size[0] * (p[1] + size[1] * p[2]); }

  bool is_cell(const Index3 &p) const
  {
    return p[0] >= 0 && p[1] >= 0 && p[2] >= 0 && p[0] < cells[0] && p[1] < cells[1] && p[2] < cells[2];
  }

  std::size_t node(const Index3 &p) const
  {
    return is_cell(p) ? static_cast<std::size_t>(p[0] + cells[0] * (p[1] + cells[1] * p[2])) : exterior_node();
  }

  bool precedes(SampleId a, SampleId b) const
  {
    const float va = field.values[a];
    const float vb = field.values[b];
    return va > vb || (va == vb && a < b);
  }

  SampleId first_of(const std::vector<SampleId> &corners) const
  {
    return *std::min_element(corners.begin(), corners.end(), [&](auto a, auto b) { return precedes(a, b); });
  }

  SampleId max_vertex_of_cell(const Index3 &p) const
  {
    std::vector<SampleId> corners;
    for (int corner = 0; corner < 8; ++corner)
      corners.push_back(sample({p[0] + (corner & 1), p[1] + (corner >> 1 & 1), p[2] + (corner >> 2)}));
    return first_of(corners);
  }

  /// -1 for the exterior, which no sample gives birth to.
  std::vector<SampleId> max_vertices() const
  {
    std::vector<SampleId> result(exterior_node() + 1, -1);
    for (std::int64_t z = 0; z < cells[2]; ++z)
      for (std::int64_t y = 0; y < cells[1]; ++y)
        for (std::int64_t x = 0; x < cells[0]; ++x)
          result[node({x, y, z})] = max_vertex_of_cell({x, y, z});
    return result;
  }

  float value(const std::vector<SampleId> &max_vertex, std::size_t node) const
  {
    return max_vertex[node] < 0 ? std::numeric_limits<float>::infinity() : field.values[max_vertex[node]];
  }
};

std::vector<SampleId> face_corners(const Complex &complex, const Index3 &p, int axis)
{
  std::vector<SampleId> corners;
  for (int i = 0; i < 4; ++i) {
    Index3 q = p;
    q[(axis + 1) % 3] += i & 1;
    q[(axis + 2) % 3] += i >> 1;
    corners.push_back(complex.sample(q));
  }
  return corners;
}

std::vector<Face> all_faces(const Complex &complex)
{
  std::vector<Face> faces;
  for (std::int64_t z = 0; z < complex.size[2]; ++z)
    for (std::int64_t y = 0; y < complex.size[1]; ++y)
      for (std::int64_t x = 0; x < complex.size[0]; ++x)
        for (int axis = 0; axis < 3; ++axis) {
          const Index3 upper{x, y, z};
          Index3 lower = upper;
          --lower[axis];
          const bool has_upper = complex.is_cell(upper);
          const bool has_lower = complex.is_cell(lower);
          if (!has_upper && !has_lower)
            continue;
          if ((!has_upper || !has_lower) && complex.exterior == Exterior::none)
            continue;
          faces.push_back({axis, complex.sample(upper), complex.node(lower), complex.node(upper),
                           complex.first_of(face_corners(complex, upper, axis)), 0, 0});
        }
  return faces;
}

/// Per 3 * sample of the lowest corner + axis, the face's place in the list, -1 where there is none.
std::vector<std::ptrdiff_t> places_of_faces(const Complex &complex, const std::vector<Face> &faces)
{
  std::vector<std::ptrdiff_t> place(3 * complex.field.values.size(), -1);
  for (std::size_t i = 0; i < faces.size(); ++i)
    place[static_cast<std::size_t>(3 * faces[i].lowest_corner + faces[i].axis)] = static_cast<std::ptrdiff_t>(i);
  return place;
}

/// The faces that have v as a corner: their lowest corner is v or one lower on the axes that they extend along.
std::vector<const Face *> star_of(const Complex &complex, const std::vector<Face> &faces,
                                  const std::vector<std::ptrdiff_t> &place, SampleId v)
{
  std::vector<const Face *> star;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 4; ++i) {
      Index3 low{v % complex.size[0], v / complex.size[0] % complex.size[1], v / complex.size[0] / complex.size[1]};
      low[(axis + 1) % 3] -= i & 1;
      low[(axis + 2) % 3] -= i >> 1;
      if (low[0] < 0 || low[1] < 0 || low[2] < 0)
        continue;
      const std::ptrdiff_t at = place[static_cast<std::size_t>(3 * complex.sample(low) + axis)];
      if (at >= 0)
        star.push_back(&faces[static_cast<std::size_t>(at)]);
    }
  return star;
}

/// Hops within star(v) from each node of it to the nearest one that is not newborn at v.
std::map<std::size_t, int> layers_in_star(const std::vector<SampleId> &max_vertex,
                                          const std::vector<const Face *> &star, SampleId v)
{
  std::map<std::size_t, int> layer;
  constexpr int kFar = 1000;
  for (const Face *face : star)
    for (const std::size_t node : {face->a, face->b})
      layer[node] = max_vertex[node] == v ? kFar : 0;
  for (int round = 0; round < 8; ++round)
    for (const Face *face : star) {
      layer[face->a] = std::min(layer[face->a], layer[face->b] + 1);
      layer[face->b] = std::min(layer[face->b], layer[face->a] + 1);
    }
  for (auto &[node, hops] : layer)
    hops = std::min(hops, kFar);
  return layer;
}

std::vector<Face> faces_in_order_k(const Complex &complex, const std::vector<SampleId> &max_vertex)
{
  std::vector<Face> faces = all_faces(complex);
  const auto place = places_of_faces(complex, faces);
  std::map<SampleId, std::map<std::size_t, int>> layers;
  for (Face &face : faces) {
    if (layers.count(face.max_vertex) == 0)
      layers[face.max_vertex] =
          layers_in_star(max_vertex, star_of(complex, faces, place, face.max_vertex), face.max_vertex);
    const auto &star = layers[face.max_vertex];
    face.layer = std::min(star.at(face.a), star.at(face.b));
    face.steepest = std::max(complex.value(max_vertex, face.a), complex.value(max_vertex, face.b));
  }
  std::sort(faces.begin(), faces.end(), [&](const Face &f, const Face &g) {
    if (f.max_vertex != g.max_vertex)
      return complex.precedes(f.max_vertex, g.max_vertex);
    return std::make_tuple(f.layer, -f.steepest, f.axis, f.lowest_corner) <
           std::make_tuple(g.layer, -g.steepest, g.axis, g.lowest_corner);
  });
  return faces;
}

std::size_t find(Nodes &parent, std::size_t node)
{
  while (parent[node] != node)
    node = parent[node] = parent[parent[node]];
  return node;
}

Nodes singletons(std::size_t count)
{
  Nodes nodes(count);
  std::iota(nodes.begin(), nodes.end(), std::size_t{0});
  return nodes;
}

} // namespace

std::size_t node_count(const Field &field, Exterior exterior)
{
  const auto cells = static_cast<std::size_t>((field.size[0] - 1) * (field.size[1] - 1) * (field.size[2] - 1));
  return exterior == Exterior::infinite ? cells + 1 : cells;
}

std::vector<OrderedFace> naive_order(const Field &field, Exterior exterior)
{
  const Complex complex(field, exterior);
  std::vector<OrderedFace> order;
  for (const Face &face : faces_in_order_k(complex, complex.max_vertices()))
    order.push_back({3 * face.lowest_corner + face.axis, face.a, face.b, field.values[face.max_vertex]});
  return order;
}

std::vector<SampleId> naive_max_vertices(const Field &field)
{
  std::vector<SampleId> vertices = Complex(field, Exterior::none).max_vertices();
  vertices.pop_back(); // the exterior's
  return vertices;
}

std::vector<TreeEdge> naive_tree(const Field &field, Exterior exterior)
{
  const Complex complex(field, exterior);
  const auto max_vertex = complex.max_vertices();
  Nodes d1 = singletons(complex.exterior_node() + 1);
  std::vector<TreeEdge> tree;
  for (const Face &face : faces_in_order_k(complex, max_vertex)) {
    std::size_t elder = find(d1, face.a);
    std::size_t younger = find(d1, face.b);
    if (elder == younger)
      continue;
    const float elder_value = complex.value(max_vertex, elder);
    const float younger_value = complex.value(max_vertex, younger);
    if (younger_value > elder_value || (younger_value == elder_value && max_vertex[younger] < max_vertex[elder]))
      std::swap(elder, younger);
    const float persistence = std::min(elder_value, younger_value) - field.values[face.max_vertex];
    tree.push_back({3 * face.lowest_corner + face.axis, face.a, face.b, persistence});
    d1[younger] = elder;
  }
  return tree;
}

std::vector<std::size_t> naive_partition(const std::vector<TreeEdge> &tree, std::size_t nodes, float delta)
{
  Nodes d2 = singletons(nodes);
  for (const TreeEdge &edge : tree)
    if (edge.persistence < delta) {
      const std::size_t a = find(d2, edge.a);
      const std::size_t b = find(d2, edge.b);
      d2[std::max(a, b)] = std::min(a, b);
    }
  Nodes region(nodes);
  for (std::size_t node = 0; node < nodes; ++node)
    region[node] = find(d2, node);
  return region;
}

std::vector<std::size_t> naive_partition(const Field &field, Exterior exterior, float delta)
{
  return naive_partition(naive_tree(field, exterior), node_count(field, exterior), delta);
}

std::vector<std::size_t> canonical(const std::vector<std::uint32_t> &labels)
{
  std::map<std::uint32_t, std::size_t> first;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < labels.size(); ++i)
    result.push_back(first.emplace(labels[i], i).first->second);
  return result;
}

} // namespace volsurf::support
