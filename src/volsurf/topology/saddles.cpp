#include "volsurf/topology/saddles.h"

#include "volsurf/core/vectorise.h"
#include "volsurf/topology/star_tables.h"

#include <cstring>
#include <limits>

namespace volsurf {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Lane o is octant o, or lane f is star face f; faces 8 to 11 have lanes of their own, of which the last four are
// empty. Nothing but the number of faces branches, since no star foretells the next one.

/// The neighbours of all octants across an axis.
template <int Axis, typename Lanes> VOLSURF_LANES_INLINE Lanes across(const Lanes &octants)
{
  constexpr int kBit = 1 << Axis;
  return __builtin_shufflevector(octants, octants, 0 ^ kBit, 1 ^ kBit, 2 ^ kBit, 3 ^ kBit, 4 ^ kBit, 5 ^ kBit, 6 ^ kBit,
                                 7 ^ kBit);
}

VOLSURF_LANES_INLINE Float32x8 lesser(const Float32x8 &a, const Float32x8 &b)
{
  return a < b ? a : b;
}

/// The least of all lanes, in each lane.
VOLSURF_LANES_INLINE Float32x8 least(Float32x8 lanes)
{
  lanes = lesser(lanes, across<2>(lanes));
  lanes = lesser(lanes, across<1>(lanes));
  return lesser(lanes, across<0>(lanes));
}

/// Loads the values two at a time: single ones, stored and loaded again as a whole, would stall the loads.
VOLSURF_LANES_INLINE Float32x8 octants_at(const OctantRows &values, std::int64_t x)
{
  const auto pair = [&](std::size_t i) {
    double both = 0;
    std::memcpy(&both, values[i] + x, sizeof both);
    return both;
  };
  const Float64x4 pairs = {pair(0), pair(1), pair(2), pair(3)};
  return reinterpret_cast<const Float32x8 &>(pairs);
}

/// The first faces in K of the newborn octants. They lead to those neighbours that are not newborn and have the largest
/// I, ties to the lowest axis; where all three are newborn, the table tells.
VOLSURF_LANES_INLINE unsigned first_faces(unsigned cells, const Float32x8 &values, const StarTables &tables)
{
  const Float32x8 old = lanes_of_set(cells) ? Float32x8{} - kInfinity : values;
  const Float32x8 x = across<0>(old);
  const Float32x8 y = across<1>(old);
  const Float32x8 z = across<2>(old);
  const unsigned next_to_old = cells & ~tables.deep[cells];
  const unsigned along_z = next_to_old & set_of_lanes(z > (y > x ? y : x));
  const unsigned along_y = next_to_old & ~along_z & set_of_lanes(y > x);
  const unsigned along_x = next_to_old & ~along_z & ~along_y;
  return tables.faces_across[0][along_x] | tables.faces_across[1][along_y] | tables.faces_across[2][along_z] |
         tables.deep_faces[cells];
}

/// -I of the steepest cell of each face.
struct Descents {
  Float32x8 low; ///< faces 0 to 7
  Float32x8 high;
};

VOLSURF_LANES_INLINE Descents descents_of_faces(const Float32x8 &values)
{
  const Float32x8 v = -values;
  return {lesser(__builtin_shufflevector(v, v, 0, 2, 4, 6, 0, 1, 4, 5),
                 __builtin_shufflevector(v, v, 1, 3, 5, 7, 2, 3, 6, 7)),
          lesser(__builtin_shufflevector(v, v, 0, 1, 2, 3, 0, 1, 2, 3),
                 __builtin_shufflevector(v, v, 4, 5, 6, 7, 4, 5, 6, 7))};
}

/// The steepest face of a set, ties to the lowest number.
VOLSURF_LANES_INLINE int steepest_face(unsigned faces, const Descents &descents)
{
  const Float32x8 none = Float32x8{} + kInfinity;
  const Float32x8 low = lanes_of_set(faces & 0xFFU) ? descents.low : none;
  const Float32x8 high = lanes_of_set(faces >> 8) ? descents.high : none;
  const Float32x8 steepest = least(lesser(low, high));
  return __builtin_ctz(set_of_lanes(low == steepest) | set_of_lanes(high == steepest) << 8);
}

/// The number of faces is known beforehand, so that a loop that was expected to go on is left early.
VOLSURF_LANES_INLINE SaddleFaces saddle_faces(const StarPattern &star, const Float32x8 &values, unsigned present,
                                              const StarTables &tables)
{
  const unsigned cells = newborn_cells(star.mask);
  const unsigned faces = newborn_faces(star.mask);
  const Descents descents = descents_of_faces(values);
  const unsigned inner = tables.inner_faces[present];
  unsigned separating = faces & ~first_faces(cells, values, tables);
  unsigned parts = tables.parts_outside(cells, faces);
  SaddleFaces saddles;
  for (;;) {
    const unsigned joining = tables.joining[separating] & inner;
    const int face = steepest_face(tables.of_first_layer(joining, cells), descents);
    saddles.add(face);
    parts &= parts - 1;
    if ((parts & (parts - 1)) == 0)
      return saddles;
    separating &= ~(1U << face);
  }
}

} // namespace

VOLSURF_VECTORISE
void find_saddle_faces(const PatternList &meeting, const OctantRows &values, Exterior exterior, SaddleFaces *faces)
{
  const StarTables &tables = star_tables();
  for (const StarPattern &star : meeting) {
    const unsigned present = exterior == Exterior::none ? star.real_cells : kAllOctants;
    *faces++ = saddle_faces(star, octants_at(values, star.x), present, tables);
  }
}

} // namespace volsurf
