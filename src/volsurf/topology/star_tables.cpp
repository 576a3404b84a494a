#include "volsurf/topology/star_tables.h"

#include <algorithm>
#include <memory>

namespace volsurf {

namespace {

constexpr int kLayers = 3; // of newborn octants
constexpr std::uint8_t kNoLayer = 255;

bool has_bit(unsigned set, int bit)
{
  return (set >> bit & 1U) != 0;
}

/// Breadth-first over the cube of octants, all octants that are not newborn at once.
std::array<std::uint8_t, kOctants> layers_of(unsigned newborn_cells)
{
  std::array<std::uint8_t, kOctants> layer{};
  for (int o = 0; o < kOctants; ++o)
    layer[o] = has_bit(newborn_cells, o) ? kNoLayer : 0;
  for (int hop = 0; hop < kLayers; ++hop)
    for (int o = 0; o < kOctants; ++o)
      for (int axis = 0; axis < 3; ++axis)
        if (layer[o] == kNoLayer && layer[o ^ (1 << axis)] == hop)
          layer[o] = static_cast<std::uint8_t>(hop + 1);
  return layer;
}

std::uint8_t deep_octants(unsigned newborn_cells)
{
  unsigned deep = 0;
  for (int o = 0; o < kOctants; ++o) {
    const unsigned with_neighbours = 1U << o | 1U << (o ^ 1) | 1U << (o ^ 2) | 1U << (o ^ 4);
    if ((newborn_cells & with_neighbours) == with_neighbours)
      deep |= 1U << o;
  }
  return static_cast<std::uint8_t>(deep);
}

std::array<std::uint8_t, kOctants> deep_axes_of(const std::array<std::uint8_t, kOctants> &layer)
{
  std::array<std::uint8_t, kOctants> axes{};
  for (int o = 0; o < kOctants; ++o)
    for (int axis = 2; axis >= 0; --axis)
      if (layer[o] != kNoLayer && layer[o ^ (1 << axis)] + 1 == layer[o])
        axes[o] = static_cast<std::uint8_t>(axis);
  return axes;
}

std::uint16_t faces_across(unsigned octants, int axis)
{
  unsigned faces = 0;
  for (int o = 0; o < kOctants; ++o)
    if (has_bit(octants, o))
      faces |= 1U << star_face_of(o, axis);
  return static_cast<std::uint16_t>(faces);
}

std::uint16_t deep_faces_of(std::uint8_t deep, const std::array<std::uint8_t, kOctants> &deep_axis)
{
  unsigned faces = 0;
  for (int o = 0; o < kOctants; ++o)
    if (has_bit(deep, o))
      faces |= 1U << star_face_of(o, deep_axis[o]);
  return static_cast<std::uint16_t>(faces);
}

std::array<std::uint16_t, kFaceLayers> layer_faces_of(const std::array<std::uint8_t, kOctants> &layer)
{
  std::array<std::uint16_t, kFaceLayers> faces{};
  for (int f = 0; f < kStarFaces; ++f) {
    const std::uint8_t layer_of_face = std::min(layer[lower_octant(f)], layer[upper_octant(f)]);
    if (layer_of_face != kNoLayer)
      faces[layer_of_face] = static_cast<std::uint16_t>(faces[layer_of_face] | 1U << f);
  }
  return faces;
}

/// The octants that are joined to each by faces that are not newborn.
std::array<std::uint8_t, kOctants> parts_of(unsigned newborn_faces)
{
  std::array<std::uint8_t, kOctants> part{};
  for (int o = 0; o < kOctants; ++o)
    part[o] = static_cast<std::uint8_t>(1U << o);
  for (int f = 0; f < kStarFaces; ++f) {
    if (has_bit(newborn_faces, f))
      continue;
    const auto joined = static_cast<std::uint8_t>(part[lower_octant(f)] | part[upper_octant(f)]);
    for (int o = 0; o < kOctants; ++o)
      if (has_bit(joined, o))
        part[o] = joined;
  }
  return part;
}

std::uint16_t faces_joining(const std::array<std::uint8_t, kOctants> &part)
{
  unsigned faces = 0;
  for (int f = 0; f < kStarFaces; ++f)
    if (part[lower_octant(f)] != part[upper_octant(f)])
      faces |= 1U << f;
  return static_cast<std::uint16_t>(faces);
}

std::uint16_t faces_within(unsigned octants)
{
  unsigned faces = 0;
  for (int f = 0; f < kStarFaces; ++f)
    if (has_bit(octants, lower_octant(f)) && has_bit(octants, upper_octant(f)))
      faces |= 1U << f;
  return static_cast<std::uint16_t>(faces);
}

std::uint16_t lone_and_joined_of(const std::array<std::uint8_t, kOctants> &part)
{
  unsigned bits = 0;
  unsigned next_part = 1U << kOctants;
  for (int o = 0; o < kOctants; ++o) {
    const bool lowest_of_part = (part[o] & ((1U << o) - 1U)) == 0;
    if (part[o] == 1U << o) {
      bits |= 1U << o;
    } else if (lowest_of_part) {
      bits |= next_part;
      next_part <<= 1;
    }
  }
  return static_cast<std::uint16_t>(bits);
}

std::unique_ptr<StarTables> make_tables()
{
  auto tables = std::make_unique<StarTables>();
  for (unsigned cells = 0; cells < 256; ++cells) {
    const auto layer = layers_of(cells);
    tables->deep[cells] = deep_octants(cells);
    tables->deep_axis[cells] = deep_axes_of(layer);
    tables->deep_faces[cells] = deep_faces_of(tables->deep[cells], tables->deep_axis[cells]);
    for (int axis = 0; axis < 3; ++axis)
      tables->faces_across[axis][cells] = faces_across(cells, axis);
    tables->layer_faces[cells] = layer_faces_of(layer);
    tables->inner_faces[cells] = faces_within(cells);
  }
  for (unsigned faces = 0; faces < 4096; ++faces) {
    const auto part = parts_of(faces);
    tables->joining[faces] = faces_joining(part);
    tables->lone_and_joined[faces] = lone_and_joined_of(part);
  }
  return tables;
}

} // namespace

const StarTables &star_tables()
{
  static const std::unique_ptr<StarTables> tables = make_tables();
  return *tables;
}

} // namespace volsurf
