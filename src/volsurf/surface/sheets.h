// The sheets of a closed surface of faces at one sample, as tables over the pattern of inside cells.
//
// Where cells of the inside touch along an edge or at a corner only, the surface of faces is not a manifold there. It
// is made one by giving each sheet a copy of the point: the faces at an edge that belong to the same inside cell stay
// together, so that inside cells that touch along an edge are taken apart.
//
// Octants and star faces are numbered as core/star.h says.
#pragma once

#include <array>
#include <cstdint>

namespace volsurf {

/// An edge of a star: 2 * axis towards the lower, 2 * axis + 1 towards the higher sample.
constexpr int kStarEdges = 6;
constexpr std::uint8_t kNoSheet = 255;

struct SheetTables {
  /// sheet[inside][f]: the sheet of star face f, 0 .. 3, or kNoSheet where there is no face.
  std::array<std::array<std::uint8_t, 12>, 256> sheet;

  /// pinched[inside]: the star edges that have four faces, all of one sheet: no copy of the point takes them apart.
  std::array<std::uint8_t, 256> pinched;

  /// Whether a point with this pattern of star faces may need several sheets or have pinched edges.
  std::array<bool, 4096> may_split;
};

/// Computed once, on first use; thread-safe.
const SheetTables &sheet_tables();

} // namespace volsurf
