#include "volsurf/topology/newborn.h"

#include "support/fields.h"
#include "support/row_patterns.h"

#include "volsurf/topology/star_tables.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

/// Whether sample v comes before all of the samples at v + step * bit, for the steps of a cell or face.
bool is_newborn(const Field &field, const Index3 &v, const Index3 &step)
{
  const SampleId self = sample_at(field, v);
  for (int corner = 1; corner < 8; ++corner) {
    Index3 p = v;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] += (corner >> axis & 1) * step[axis];
    const SampleId other = sample_at(field, p);
    const bool before =
        field.values[self] > field.values[other] || (field.values[self] == field.values[other] && self <= other);
    if (!before)
      return false;
  }
  return true;
}

Index3 step_of_octant(int octant)
{
  return {(octant & 1) * 2 - 1, (octant >> 1 & 1) * 2 - 1, (octant >> 2 & 1) * 2 - 1};
}

/// Of the cells and faces that are in the volume.
NewbornMask naive_mask(const Field &field, const Index3 &v, unsigned real)
{
  NewbornMask mask = 0;
  for (int octant = 0; octant < kOctants; ++octant)
    if ((real >> octant & 1U) != 0 && is_newborn(field, v, step_of_octant(octant)))
      mask |= 1U << octant;
  for (int face = 0; face < kStarFaces; ++face) {
    Index3 step = step_of_octant(lower_octant(face));
    step[face / 4] = 0;
    if (((real >> lower_octant(face) | real >> upper_octant(face)) & 1U) != 0 && is_newborn(field, v, step))
      mask |= 1U << (kOctants + face);
  }
  return mask;
}

RowPatterns naive_patterns(const Field &field, const BorderRule &border, std::int64_t y, std::int64_t z)
{
  const StarTables &tables = star_tables();
  RowPatterns patterns;
  for (std::int64_t x = 0; x < field.size[0]; ++x) {
    const unsigned real = border.real_cells(x, y, z);
    const NewbornMask mask = border.complete(naive_mask(field, {x, y, z}, real), real);
    if (tables.deep[newborn_cells(mask)] != 0)
      patterns[0].emplace_back(x, mask);
    if (__builtin_popcount(tables.parts_outside(newborn_cells(mask), newborn_faces(mask))) >= 2)
      patterns[1].emplace_back(x, mask);
  }
  return patterns;
}

/// Rows of several blocks, now and then.
Field field_with_long_rows()
{
  Dice dice(*random_seed());
  Field field{{dice.one_in(10) ? dice.between(200, 600) : dice.between(2, 80), 3, 3}, {}};
  const std::int64_t levels = dice.between(1, 40);
  for (std::int64_t i = 0; i < field.size[0] * field.size[1] * field.size[2]; ++i)
    field.values.push_back(-static_cast<float>(dice.between(0, levels)));
  return field;
}

} // namespace

RC_GTEST_PROP(NewbornPatterns, AreTheCellsAndFacesWhoseFirstCornerIsTheSample, ())
{
  const Field field = *rc::gen::element(true, false) ? *random_field(7) : field_with_long_rows();
  const BorderRule border(field.size, *rc::gen::element(Exterior::none, Exterior::infinite));
  const PaddedField padded(field.size, field.values);
  for (std::int64_t z = 0; z < field.size[2]; ++z)
    for (std::int64_t y = 0; y < field.size[1]; ++y)
      RC_ASSERT(row_patterns(padded, border, y, z) == naive_patterns(field, border, y, z));
}

TEST(BorderRule, RealCellsAreTheOctantsInTheVolume)
{
  const Index3 samples{2, 3, 4};
  const BorderRule border(samples, Exterior::none);
  for_each_sample(samples, [&](const Index3 &p, SampleId) {
    for (int octant = 0; octant < kOctants; ++octant) {
      bool inside = true;
      for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t cell = p[axis] - 1 + (octant >> axis & 1);
        inside = inside && cell >= 0 && cell + 1 < samples[axis];
      }
      EXPECT_EQ(border.real_cells(p[0], p[1], p[2]) >> octant & 1U, inside ? 1U : 0U);
    }
  });
}
