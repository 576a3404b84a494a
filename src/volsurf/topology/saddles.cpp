#include "volsurf/topology/saddles.h"

#include "volsurf/core/vectorise.h"
#include "volsurf/topology/star_tables.h"

#include <cstring>
#include <limits>

namespace volsurf {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Lane o is octant o, or lane f is star face f; faces 8 to 11 have lanes of their own, of which the last four are
// empty. Parts are named by numbers: two octants are in one part if these are the same. Nothing branches, since no star
// foretells the next one.

/// The neighbours of all octants across an axis.
template <int Axis, typename Lanes> VOLSURF_LANES_INLINE Lanes across(const Lanes &octants)
{
  constexpr int kBit = 1 << Axis;
  return __builtin_shufflevector(octants, octants, 0 ^ kBit, 1 ^ kBit, 2 ^ kBit, 3 ^ kBit, 4 ^ kBit, 5 ^ kBit, 6 ^ kBit,
                                 7 ^ kBit);
}

/// The lower and the upper octants of faces 0 to 7 and 8 to 11.
template <typename Lanes> struct SidesOfFaces {
  Lanes lower_low;
  Lanes upper_low;
  Lanes lower_high;
  Lanes upper_high;
};

template <typename Lanes> VOLSURF_LANES_INLINE SidesOfFaces<Lanes> sides_of_faces(const Lanes &octants)
{
  return {__builtin_shufflevector(octants, octants, 0, 2, 4, 6, 0, 1, 4, 5),
          __builtin_shufflevector(octants, octants, 1, 3, 5, 7, 2, 3, 6, 7),
          __builtin_shufflevector(octants, octants, 0, 1, 2, 3, 0, 1, 2, 3),
          __builtin_shufflevector(octants, octants, 4, 5, 6, 7, 4, 5, 6, 7)};
}

template <typename Lanes> VOLSURF_LANES_INLINE Lanes lesser(const Lanes &a, const Lanes &b)
{
  return a < b ? a : b;
}

/// The least of all lanes, in each lane.
template <typename Lanes> VOLSURF_LANES_INLINE Lanes least(Lanes lanes)
{
  lanes = lesser(lanes, across<2>(lanes));
  lanes = lesser(lanes, across<1>(lanes));
  return lesser(lanes, across<0>(lanes));
}

/// Loads the values two at a time: single ones, stored and loaded again as a whole, would stall the loads.
VOLSURF_LANES_INLINE Float32x8 values_of(const Star &star)
{
  const auto pair = [&](int i) {
    double both;
    std::memcpy(&both, star.pairs[i], sizeof both);
    return both;
  };
  const Float64x4 pairs = {pair(0), pair(1), pair(2), pair(3)};
  return reinterpret_cast<const Float32x8 &>(pairs);
}

VOLSURF_LANES_INLINE UInt32x8 lanes_of_table(const std::array<std::uint8_t, kOctants> &entry)
{
  constexpr UInt32x8 kByte = {0, 8, 16, 24, 0, 8, 16, 24};
  std::array<unsigned, 2> words;
  std::memcpy(words.data(), entry.data(), sizeof words);
  const UInt32x8 lanes = {words[0], words[0], words[0], words[0], words[1], words[1], words[1], words[1]};
  return lanes >> kByte & 0xFFU; // compilers convert vectors of bytes one by one
}

/// All ones in the lanes of a set.
VOLSURF_LANES_INLINE UInt32x8 lanes_of_set(unsigned set)
{
  constexpr UInt32x8 kBits = {1, 2, 4, 8, 16, 32, 64, 128};
  return (kBits & set) != 0 ? ~UInt32x8{} : UInt32x8{};
}

/// Each newborn octant comes to the part of the neighbour to which its first face in K leads: of those that are not
/// newborn the one with the largest I, ties to the lowest axis; where all three are newborn, as the table says.
VOLSURF_LANES_INLINE UInt32x8 parts_before_saddles(const Star &star, const Float32x8 &values)
{
  const StarTables &tables = star_tables();
  const UInt32x8 newborn = lanes_of_set(star.cells);
  const UInt32x8 moves = lanes_of_set(star.cells & star.present);
  const Float32x8 old = newborn != 0 ? Float32x8{} - kInfinity : values;
  const Float32x8 x = across<0>(old);
  const Float32x8 y = across<1>(old);
  const Float32x8 z = across<2>(old);
  const Float32x8 xy = y > x ? y : x;
  const UInt32x8 axis_xy = y > x ? UInt32x8{} + 1 : UInt32x8{};
  const UInt32x8 axis_old = z > xy ? UInt32x8{} + 2 : axis_xy;
  const Float32x8 largest = z > xy ? z : xy;
  const UInt32x8 axis = largest == Float32x8{} - kInfinity ? lanes_of_table(tables.deep_axis[star.cells]) : axis_old;

  UInt32x8 parts = lanes_of_table(tables.parts[star.faces]);
  for (int layer = 1; layer <= kLayers; ++layer) {
    const UInt32x8 next_xy = axis == 0 ? across<0>(parts) : across<1>(parts);
    const UInt32x8 next = axis == 2 ? across<2>(parts) : next_xy;
    parts = moves != 0 ? next : parts;
  }
  return parts;
}

/// What the order K asks of the faces of a star, which have the same first corner: the layer decides, then the steepest
/// cell, then the number of the face.
struct FaceOrder {
  UInt32x8 layer_low;
  UInt32x8 layer_high;
  Float32x8 descent_low; ///< -I of the steepest cell
  Float32x8 descent_high;
};

VOLSURF_LANES_INLINE FaceOrder order_of_faces(const Star &star, const Float32x8 &values)
{
  const auto layers = sides_of_faces(lanes_of_table(star_tables().layer[star.cells]));
  const auto descents = sides_of_faces(-values);
  return {lesser(layers.lower_low, layers.upper_low), lesser(layers.lower_high, layers.upper_high),
          lesser(descents.lower_low, descents.upper_low), lesser(descents.lower_high, descents.upper_high)};
}

/// The first one in K of the faces of a set that join two parts.
VOLSURF_LANES_INLINE unsigned first_joining_face(unsigned faces, const FaceOrder &order, const UInt32x8 &parts)
{
  constexpr UInt32x8 kNumber = {0, 1, 2, 3, 4, 5, 6, 7};
  const UInt32x8 none = UInt32x8{} + 255;
  const Float32x8 no_descent = Float32x8{} + kInfinity;
  const auto sides = sides_of_faces(parts);

  const UInt32x8 joins_low = sides.lower_low != sides.upper_low ? lanes_of_set(faces & 0xFFU) : UInt32x8{};
  const UInt32x8 joins_high = sides.lower_high != sides.upper_high ? lanes_of_set(faces >> 8) : UInt32x8{};
  const UInt32x8 layer_low = joins_low != 0 ? order.layer_low : none;
  const UInt32x8 layer_high = joins_high != 0 ? order.layer_high : none;
  const UInt32x8 layer = least(lesser(layer_low, layer_high));

  const Float32x8 descent_low = layer_low == layer ? order.descent_low : no_descent;
  const Float32x8 descent_high = layer_high == layer ? order.descent_high : no_descent;
  const Float32x8 descent = least(lesser(descent_low, descent_high));

  const UInt32x8 number_low = descent_low == descent ? kNumber : none;
  const UInt32x8 number_high = descent_high == descent ? kNumber + 8 : none;
  return least(lesser(number_low, number_high))[0];
}

} // namespace

VOLSURF_VECTORISE
SaddleFaces find_saddle_faces(const Star &star, unsigned parts_outside)
{
  const Float32x8 values = values_of(star);
  const FaceOrder order = order_of_faces(star, values);
  const unsigned faces = star.faces & star_tables().inner_faces[star.present];
  UInt32x8 parts = parts_before_saddles(star, values);
  SaddleFaces saddles;
  for (;;) {
    const unsigned face = first_joining_face(faces, order, parts);
    saddles.faces[saddles.count++] = static_cast<std::uint8_t>(face);
    parts_outside &= parts_outside - 1;
    if ((parts_outside & (parts_outside - 1)) == 0)
      return saddles;
    const UInt32x8 part = UInt32x8{} + parts[lower_octant(static_cast<int>(face))];
    const UInt32x8 other = UInt32x8{} + parts[upper_octant(static_cast<int>(face))];
    parts = parts == other ? part : parts;
  }
}

} // namespace volsurf
