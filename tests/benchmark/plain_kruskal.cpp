#include "benchmark/plain_kruskal.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace volsurf::bench {

namespace {

using Id = std::uint32_t;

/// A face, with the keys that K begins with.
struct Face {
  float value; ///< I of its max vertex
  Id max_vertex;
  Id id; ///< 3 * sample of its lowest corner + axis
};

bool precedes(const Face &a, const Face &b)
{
  return a.value > b.value || (a.value == b.value && a.max_vertex < b.max_vertex);
}

class UnionFind {
public:
  explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Id{0}); }

  Id find(Id node)
  {
    while (parent_[node] != node)
      node = parent_[node] = parent_[parent_[node]];
    return node;
  }

  void link(Id child, Id root) { parent_[child] = root; }

  /// Each node's root.
  std::vector<Id> flattened() &&
  {
    for (Id &parent : parent_)
      parent = find(parent);
    return std::move(parent_);
  }

private:
  std::vector<Id> parent_;
};

class Merge {
public:
  Merge(const Index3 &samples, const std::vector<float> &field, float delta)
      : n_{static_cast<Id>(samples[0]), static_cast<Id>(samples[1]), static_cast<Id>(samples[2])},
        sample_step_{1, n_[0], n_[0] * n_[1]}, cell_step_{1, n_[0] - 1, (n_[0] - 1) * (n_[1] - 1)}, field_(field),
        delta_(delta), vertex_of_cell_(cell_vertices()), elders_(vertex_of_cell_.size()),
        regions_(vertex_of_cell_.size()), count_(vertex_of_cell_.size())
  {
  }

  PlainRegions run()
  {
    std::vector<Face> faces = inner_faces();
    std::sort(faces.begin(), faces.end(), precedes);
    for (auto first = faces.begin(); first != faces.end();) {
      auto last = first;
      while (last != faces.end() && last->max_vertex == first->max_vertex)
        ++last;
      if (last - first > 1)
        order_by_rest_of_k(&*first, &*first + (last - first));
      std::for_each(first, last, [this](const Face &face) { join(face); });
      first = last;
    }
    return {count_, std::move(regions_).flattened()};
  }

private:
  struct Cells {
    Id low;
    Id high;
  };

  Id cell_count() const { return (n_[0] - 1) * (n_[1] - 1) * (n_[2] - 1); }

  Id later(Id a, Id b) const { return field_[b] > field_[a] || (field_[b] == field_[a] && b < a) ? b : a; }

  std::vector<Id> cell_vertices() const
  {
    std::vector<Id> vertices;
    vertices.reserve(cell_count());
    for (Id z = 0; z + 1 < n_[2]; ++z)
      for (Id y = 0; y + 1 < n_[1]; ++y)
        for (Id x = 0; x + 1 < n_[0]; ++x) {
          const Id corner = x + sample_step_[1] * y + sample_step_[2] * z;
          vertices.push_back(later(max_vertex_of_face(corner, 2), max_vertex_of_face(corner + sample_step_[2], 2)));
        }
    return vertices;
  }

  Id max_vertex_of_face(Id corner, unsigned axis) const
  {
    const Id u = sample_step_[(axis + 1) % 3];
    const Id v = sample_step_[(axis + 2) % 3];
    return later(later(corner, corner + u), later(corner + v, corner + u + v));
  }

  std::vector<Face> inner_faces() const
  {
    std::vector<Face> faces;
    faces.reserve(3 * field_.size());
    for (Id z = 0; z + 1 < n_[2]; ++z)
      for (Id y = 0; y + 1 < n_[1]; ++y)
        for (Id x = 0; x + 1 < n_[0]; ++x) {
          const Id corner = x + sample_step_[1] * y + sample_step_[2] * z;
          const std::array<bool, 3> inner{x > 0, y > 0, z > 0};
          for (unsigned axis = 0; axis < 3; ++axis)
            if (inner[axis]) {
              const Id vertex = max_vertex_of_face(corner, axis);
              faces.push_back({field_[vertex], vertex, 3 * corner + axis});
            }
        }
    return faces;
  }

  Cells cells_of(Id face) const
  {
    const Id axis = face % 3;
    const Id corner = face / 3;
    const Id rest = corner % sample_step_[2];
    const Id high = rest % n_[0] + cell_step_[1] * (rest / n_[0]) + cell_step_[2] * (corner / sample_step_[2]);
    return {high - cell_step_[axis], high};
  }

  float value(Id cell) const { return field_[vertex_of_cell_[cell]]; }

  /// Faces of one max vertex: by layer, the larger I of its cells (descending), axis, lowest corner.
  void order_by_rest_of_k(Face *first, Face *last)
  {
    struct Ranked {
      int layer;
      float minus_steepest;
      Id axis;
      Face face;
      Cells cells;
    };
    constexpr int kFar = 100;
    std::array<Ranked, 12> ranked;
    const auto end = std::transform(first, last, ranked.begin(), [&](const Face &face) {
      const Cells cells = cells_of(face.id);
      const bool born = is_newborn(cells.low, face) && is_newborn(cells.high, face);
      return Ranked{born ? kFar : 0, -std::max(value(cells.low), value(cells.high)), face.id % 3, face, cells};
    });
    // A face between two newborn cells is one hop further than the nearest face of either. It has three neighbours.
    for (bool changed = true; changed;) {
      changed = false;
      for (auto face = ranked.begin(); face != end; ++face)
        for (auto other = ranked.begin(); other != end; ++other)
          if (face->layer > other->layer + 1 && share_newborn_cell(face->cells, other->cells, face->face)) {
            face->layer = other->layer + 1;
            changed = true;
          }
    }
    std::sort(ranked.begin(), end, [](const Ranked &a, const Ranked &b) {
      return std::tie(a.layer, a.minus_steepest, a.axis, a.face.id) <
             std::tie(b.layer, b.minus_steepest, b.axis, b.face.id);
    });
    std::transform(ranked.begin(), end, first, [](const Ranked &r) { return r.face; });
  }

  bool is_newborn(Id cell, const Face &at) const { return vertex_of_cell_[cell] == at.max_vertex; }

  bool share_newborn_cell(const Cells &a, const Cells &b, const Face &at) const
  {
    const auto shared = [&](Id cell) { return (cell == b.low || cell == b.high) && is_newborn(cell, at); };
    return shared(a.low) || shared(a.high);
  }

  void join(const Face &face)
  {
    const Cells cells = cells_of(face.id);
    Id elder = elders_.find(cells.low);
    Id younger = elders_.find(cells.high);
    if (elder == younger)
      return;
    if (later(vertex_of_cell_[elder], vertex_of_cell_[younger]) != vertex_of_cell_[elder])
      std::swap(elder, younger);
    elders_.link(younger, elder);
    if (value(younger) - face.value < delta_) {
      regions_.link(regions_.find(cells.low), regions_.find(cells.high));
      --count_;
    }
  }

  std::array<Id, 3> n_;
  std::array<Id, 3> sample_step_;
  std::array<Id, 3> cell_step_;
  const std::vector<float> &field_;
  float delta_;
  std::vector<Id> vertex_of_cell_;
  UnionFind elders_;  // D1, its roots are the cells of largest I
  UnionFind regions_; // D2
  std::size_t count_;
};

} // namespace

PlainRegions plain_kruskal(const Index3 &samples, const std::vector<float> &field, float delta)
{
  if (field.size() > (std::size_t{1} << 32) / 3)
    throw std::runtime_error("too many samples for 32-bit ids of faces");
  return Merge(samples, field, delta).run();
}

} // namespace volsurf::bench
