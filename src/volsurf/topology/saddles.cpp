#include "volsurf/topology/saddles.h"

#include "volsurf/topology/star_tables.h"

#include <algorithm>

namespace volsurf {

namespace {

/// For each octant, the set of octants that it is joined to.
using Parts = std::array<std::uint8_t, kOctants>;

void join(Parts &parts, int a, int b)
{
  const auto joined = static_cast<std::uint8_t>(parts[a] | parts[b]);
  for (unsigned rest = joined; rest != 0; rest &= rest - 1)
    parts[__builtin_ctz(rest)] = joined;
}

Parts parts_before_saddles(const Star &star)
{
  Parts parts = star_tables().parts[star.faces];
  for (unsigned rest = star.cells & star.present; rest != 0; rest &= rest - 1) {
    const int octant = __builtin_ctz(rest);
    join(parts, octant, octant ^ (1 << star.first_axis[octant]));
  }
  return parts;
}

/// The first face in K that joins two parts. They all have the same first corner, so the layer decides, then the
/// steepest cell, then the number of the face.
int first_joining_face(const Star &star, const Parts &parts)
{
  const auto &layers = star_tables().layer[star.cells];
  int best_face = -1;
  std::uint8_t best_layer = kNoLayer;
  float best_value = 0;
  for (unsigned rest = star_tables().joining[star.faces]; rest != 0; rest &= rest - 1) {
    const int face = __builtin_ctz(rest);
    const int a = lower_octant(face);
    const int b = upper_octant(face);
    if (parts[a] == parts[b] || !(star.present >> a & star.present >> b & 1U))
      continue;
    const std::uint8_t layer = std::min(layers[a], layers[b]);
    const float value = std::max(star.values[a], star.values[b]);
    if (best_face < 0 || layer < best_layer || (layer == best_layer && value > best_value)) {
      best_face = face;
      best_layer = layer;
      best_value = value;
    }
  }
  return best_face;
}

} // namespace

SaddleFaces find_saddle_faces(const Star &star, int parts)
{
  Parts joined = parts_before_saddles(star);
  SaddleFaces saddles;
  for (;;) {
    const int face = first_joining_face(star, joined);
    saddles.faces[saddles.count++] = static_cast<std::uint8_t>(face);
    if (saddles.count == parts - 1)
      return saddles;
    join(joined, lower_octant(face), upper_octant(face));
  }
}

} // namespace volsurf
