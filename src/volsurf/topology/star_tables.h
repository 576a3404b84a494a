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

  /// deep_axis[cells][o]: the axis of the first face in K of newborn octant o, where its three neighbours are newborn
  /// too: towards the neighbour of the next lower layer, lowest axis first.
  std::array<std::array<std::uint8_t, kOctants>, 256> deep_axis;

  /// parts[faces][o]: the set of octants that are joined to octant o by faces that are not newborn.
  std::array<std::array<std::uint8_t, kOctants>, 4096> parts;

  /// joining[faces]: the newborn faces between two of those sets.
  std::array<std::uint16_t, 4096> joining;

  /// part_counts[faces]: what is needed to count the parts that reach outside the star.
  struct PartCount {
    std::uint8_t joined;   ///< parts of two or more octants; none of these is newborn
    std::uint8_t isolated; ///< the set of octants that are a part of their own; they may be newborn or not
  };
  std::array<PartCount, 4096> part_counts;

  /// set_size[set]: the number of octants in a set.
  std::array<std::uint8_t, 256> set_size;

  /// The number of parts that reach outside, which have a cell that is not newborn.
  int parts_outside(unsigned cells, unsigned faces) const
  {
    const PartCount &count = part_counts[faces];
    return count.joined + set_size[count.isolated & ~cells];
  }
};

constexpr std::uint8_t kNoLayer = 255;

/// Computed once, on first use; thread-safe.
const StarTables &star_tables();

} // namespace volsurf
