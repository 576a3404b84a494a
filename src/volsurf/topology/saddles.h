// The faces of one star at which parts that reach outside it meet.
#pragma once

#include "volsurf/topology/newborn.h"

#include <array>

namespace volsurf {

/// What Kruskal needs to know of the star of a sample v.
struct Star {
  unsigned cells;                     ///< newborn octants
  unsigned faces;                     ///< newborn star faces
  unsigned present;                   ///< octants that are nodes of the dual graph
  std::array<const float *, 4> pairs; ///< I of octants 2 * i and 2 * i + 1, if present
};

/// The star faces, at most 7, that a Kruskal in order K over the newborn faces of the star takes, without the first
/// faces of newborn octants.
struct SaddleFaces {
  int count = 0;
  std::array<std::uint8_t, kOctants - 1> faces{};
};

/// `parts_outside` has a bit for each part that reaches outside the star: one face less is found.
///
/// It is exact for the whole merge: a face that Kruskal restricted to the star rejects closes a cycle of faces earlier
/// in K, so that the merge rejects it too. The first faces of newborn cells are edges of the tree and may be contracted
/// beforehand. The faces found are the ones of the tree themselves and not any others between the same parts, because a
/// part may consist of several basins.
SaddleFaces find_saddle_faces(const Star &star, unsigned parts_outside);

} // namespace volsurf
