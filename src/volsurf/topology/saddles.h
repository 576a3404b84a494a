// The faces of one star at which parts that reach outside it meet.
#pragma once

#include "volsurf/topology/star_patterns.h"

#include <array>

namespace volsurf {

/// I of the octants of the stars of a row: octants 2 * i and 2 * i + 1 of sample x are at [i][x] and [i][x + 1].
using OctantRows = std::array<const float *, 4>;

/// The star faces, at most 7, that a Kruskal in order K over the newborn faces of the star takes, without the first
/// faces of newborn octants.
class SaddleFaces {
public:
  int count() const { return count_; }
  int operator[](int i) const { return static_cast<int>(faces_ >> (kBits * i) & 15U); }
  void add(int face) { faces_ |= static_cast<std::uint32_t>(face) << (kBits * count_++); }

private:
  static constexpr int kBits = 4; // of a face: an array, stored by bytes and returned as words, would stall the loads
  int count_ = 0;
  std::uint32_t faces_ = 0;
};

/// One SaddleFaces for each sample of a row at which parts meet that reach outside: of n parts n - 1 faces.
///
/// It is exact for the whole merge: a face that Kruskal restricted to the star rejects closes a cycle of faces earlier
/// in K, so that the merge rejects it too. The first faces of newborn cells are edges of the tree and may be contracted
/// beforehand. The faces found are the ones of the tree themselves and not any others between the same parts, because a
/// part may consist of several basins.
void find_saddle_faces(const PatternList &meeting, const OctantRows &values, Exterior exterior, SaddleFaces *faces);

} // namespace volsurf
