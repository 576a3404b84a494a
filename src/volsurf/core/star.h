// The star of a sample: the up to 8 cells and 12 faces that have it as a corner.
//
// - Octant o of sample (x, y, z) is the cell at (x-1, y-1, z-1) + (o & 1, o >> 1 & 1, o >> 2 & 1).
// - Star face f = 4 * axis + k lies between the octants lower_octant(f) and upper_octant(f), which differ in the bit of
//   its axis; k counts the other two bits, lower axis first, so that f ascends by axis, then by the linear index of the
//   face's lowest corner, as the order K of faces wants it.
#pragma once

namespace volsurf {

constexpr int kOctants = 8;
constexpr unsigned kAllOctants = 0xFF; ///< as a set, bit o for octant o
constexpr int kStarFaces = 12;

constexpr int lower_octant(int star_face)
{
  constexpr std::uint8_t kLower[kStarFaces] = {0, 2, 4, 6, 0, 1, 4, 5, 0, 1, 2, 3};
  return kLower[star_face];
}

constexpr int upper_octant(int star_face)
{
  constexpr std::uint8_t kUpper[kStarFaces] = {1, 3, 5, 7, 2, 3, 6, 7, 4, 5, 6, 7};
  return kUpper[star_face];
}

/// The face of the star between octant `octant` and its neighbour along `axis`.
constexpr int star_face_of(int octant, int axis)
{
  const int low_bits = octant & ((1 << axis) - 1);
  const int high_bits = (octant >> (axis + 1)) << axis;
  return 4 * axis + (high_bits | low_bits);
}

} // namespace volsurf
