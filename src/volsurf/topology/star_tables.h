// What the pattern of newborn cells and faces in a sample's star decides, as tables over the patterns.
//
// A cell or face is newborn at sample v if v is its first corner in the sample order. Patterns are bit sets: bit o for
// octant o, bit f for star face f (cubical_complex.h). Only newborn cells may be entered into the merge at v; the faces
// of the star that are not newborn come earlier in K and have joined their two cells already.
#pragma once

#include "volsurf/topology/cubical_complex.h"

#include <array>
#include <cstdint>

namespace volsurf {

constexpr int kFaceLayers = 3; ///< an octant of layer 3 has none but nearer neighbours

struct StarTables {
  // The layer of an octant is the number of hops from it to the nearest octant that is not newborn; 0 for such octants
  // themselves.

  /// deep[cells]: the newborn octants whose three neighbours are newborn, too: of layer 2 or 3.
  std::array<std::uint8_t, 256> deep;

  /// deep_axis[cells][o]: the axis of the first face in K of newborn octant o, where it is deep: towards the
  /// neighbour of the next lower layer, lowest axis first.
  std::array<std::array<std::uint8_t, kOctants>, 256> deep_axis;

  /// deep_faces[cells]: the first faces in K of all deep octants.
  std::array<std::uint16_t, 256> deep_faces;

  /// faces_across[axis][octants]: the faces between octants of a set and their neighbours along the axis.
  std::array<std::array<std::uint16_t, 256>, 3> faces_across;

  /// joining[faces]: those of the faces that join two parts, where a part is what the other faces of the star join.
  std::array<std::uint16_t, 4096> joining;

  /// layer_faces[cells][i]: the faces whose octants' lower layer is i. None where all octants are newborn.
  std::array<std::array<std::uint16_t, kFaceLayers>, 256> layer_faces;

  /// inner_faces[octants]: the faces between two octants of a set.
  std::array<std::uint16_t, 256> inner_faces;

  /// lone_and_joined[faces]: bit o for an octant that is a part of its own, which may be newborn or not; from bit 8 on
  /// one bit for each part of two or more octants, none of which is newborn.
  std::array<std::uint16_t, 4096> lone_and_joined;

  /// One bit for each part that reaches outside, which has a cell that is not newborn.
  unsigned parts_outside(unsigned cells, unsigned faces) const { return lone_and_joined[faces] & ~cells; }

  /// Those of some faces that are in the lowest layer of them all.
  unsigned of_first_layer(unsigned faces, unsigned cells) const
  {
    const unsigned first = faces & layer_faces[cells][0];
    const unsigned second = faces & layer_faces[cells][1];
    const unsigned later = second != 0 ? second : faces;
    return first != 0 ? first : later;
  }
};

/// Computed once, on first use; thread-safe.
const StarTables &star_tables();

} // namespace volsurf
