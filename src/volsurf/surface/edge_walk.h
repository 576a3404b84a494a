// The faces of a set around each edge of the grid.
#pragma once

#include "volsurf/surface/face_set.h"

#include <array>

namespace volsurf {

/// The faces at one edge of the grid, 1 to 4, ascending but for the order of two axes.
struct EdgeFaces {
  std::array<FaceIndex, 4> faces;
  int count = 0;

  const FaceIndex *begin() const { return faces.data(); }
  const FaceIndex *end() const { return faces.data() + count; }
};

/// Calls visit(EdgeFaces) for each edge that has faces. The edge at a sample along an axis has up to four: of each
/// other axis one with its lowest corner there, and one whose lowest corner is one lower along the remaining axis.
/// Faces are met in the order of their indices, so that counting gives these.
template <typename Visit> class EdgeWalk {
public:
  EdgeWalk(const FaceSet &faces, Visit visit) : faces_(faces), visit_(visit) {}

  /// The edges at samples of plane z that have faces in plane z only: those along z.
  void walk_within(std::int64_t z) { walk_plane(z, 2, 3); }

  /// The edges at samples of plane z along x and y, which have faces in planes z and z - 1.
  void walk_with_lower(std::int64_t z) { walk_plane(z, 0, 2); }

private:
  /// 64 faces of a row, of which the next to be met has an index.
  struct FaceWord {
    std::uint64_t bits;
    FaceIndex next;
  };

  void walk_plane(std::int64_t z, int first_axis, int end_axis)
  {
    for (std::int64_t y = 0; y < faces_.samples()[1]; ++y)
      for (int edge_axis = first_axis; edge_axis < end_axis; ++edge_axis)
        walk_row(edge_axis, y, z);
  }

  void walk_row(int edge_axis, std::int64_t y, std::int64_t z)
  {
    const int a = (edge_axis + 1) % 3;
    const int b = (edge_axis + 2) % 3;
    for (std::int64_t w = 0; w < faces_.words_per_row(); ++w) {
      std::array<FaceWord, 4> around{word_at(a, w, y, z), word_below(a, b, w, y, z), word_at(b, w, y, z),
                                     word_below(b, a, w, y, z)};
      std::uint64_t any = around[0].bits | around[1].bits | around[2].bits | around[3].bits;
      for (; any != 0; any &= any - 1)
        visit_edge(around, any & (~any + 1));
    }
  }

  void visit_edge(std::array<FaceWord, 4> &around, std::uint64_t bit)
  {
    EdgeFaces edge;
    for (FaceWord &word : around)
      if ((word.bits & bit) != 0)
        edge.faces[static_cast<std::size_t>(edge.count++)] = word.next++;
    visit_(edge);
  }

  FaceWord word_at(int axis, std::int64_t w, std::int64_t y, std::int64_t z) const
  {
    return {faces_.row(axis, y, z)[w], faces_.faces_before(axis, w, y, z)};
  }

  /// Bit x: is there a face of `axis` whose lowest corner is one lower along axis `lower` than (x, y, z)?
  FaceWord word_below(int axis, int lower, std::int64_t w, std::int64_t y, std::int64_t z) const
  {
    if (lower == 1)
      return y > 0 ? word_at(axis, w, y - 1, z) : FaceWord{0, 0};
    if (lower == 2)
      return z > 0 ? word_at(axis, w, y, z - 1) : FaceWord{0, 0};
    const FaceWord word = word_at(axis, w, y, z);
    const std::uint64_t carry = w > 0 ? faces_.row(axis, y, z)[w - 1] >> 63 : 0;
    return {word.bits << 1 | carry, word.next - static_cast<FaceIndex>(carry)};
  }

  const FaceSet &faces_;
  Visit visit_;
};

} // namespace volsurf
