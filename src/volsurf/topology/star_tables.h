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

struct StarTables {
  /// layer[cells][o]: hops from octant o to the nearest octant that is not newborn; 0 for such octants themselves, and
  /// kNoLayer where all are newborn.
  std::array<std::array<std::uint8_t, kOctants>, 256> layer;

  /// deep[cells]: the newborn octants whose three neighbours are newborn, too.
  std::array<std::uint8_t, 256> deep;

  /// deep_axis[cells][o]: the axis of the first face in K of newborn octant o, where it is deep: towards the
  /// neighbour of the next lower layer, lowest axis first.
  std::array<std::array<std::uint8_t, kOctants>, 256> deep_axis;

  /// parts[faces][o]: the set of octants that are joined to octant o by faces that are not newborn.
  std::array<std::array<std::uint8_t, kOctants>, 4096> parts;

  /// inner_faces[octants]: the faces between two octants of a set.
  std::array<std::uint16_t, 256> inner_faces;

  /// lone_and_joined[faces]: bit o for an octant that is a part of its own, which may be newborn or not; from bit 8 on
  /// one bit for each part of two or more octants, none of which is newborn.
  std::array<std::uint16_t, 4096> lone_and_joined;

  /// One bit for each part that reaches outside, which has a cell that is not newborn.
  unsigned parts_outside(unsigned cells, unsigned faces) const { return lone_and_joined[faces] & ~cells; }
};

constexpr int kLayers = 3; ///< of newborn octants
constexpr std::uint8_t kNoLayer = 255;

/// Computed once, on first use; thread-safe.
const StarTables &star_tables();

} // namespace volsurf
