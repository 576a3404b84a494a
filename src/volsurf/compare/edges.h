// The edges of a mesh, each with the triangles that meet at it.
#pragma once

#include "volsurf/core/mesh.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace volsurf {

/// One side of a triangle: from its corner `corner` to the next.
struct Side {
  PointId low;
  PointId high;
  std::uint32_t triangle;
  std::uint8_t corner;
  bool ascending; ///< the triangle runs from the lower to the higher point
};

/// Calls visit(first, last) for each edge, with the range of its sides. O(n log n).
template <typename Visit> void for_each_edge(const Mesh &mesh, Visit visit)
{
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::uint8_t i = 0; i < 3; ++i) {
      const PointId from = mesh.triangles[t][i];
      const PointId to = mesh.triangles[t][(i + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), t, i, from < to});
    }
  const auto key = [](const Side &s) { return std::uint64_t{s.low} << 32 | s.high; };
  std::sort(sides.begin(), sides.end(), [&](const Side &a, const Side &b) {
    return key(a) != key(b) ? key(a) < key(b)
                            : 3 * std::uint64_t{a.triangle} + a.corner < 3 * std::uint64_t{b.triangle} + b.corner;
  });
  for (auto first = sides.cbegin(); first != sides.cend();) {
    const auto last = std::find_if(first, sides.cend(), [&](const Side &s) { return key(s) != key(*first); });
    visit(first, last);
    first = last;
  }
}

} // namespace volsurf
