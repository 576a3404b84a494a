#include "volsurf/topology/newborn.h"

#include "support/fields.h"

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

NewbornMask naive_mask(const Field &field, const Index3 &v)
{
  NewbornMask mask = 0;
  for (int octant = 0; octant < kOctants; ++octant)
    mask |= static_cast<NewbornMask>(is_newborn(field, v, step_of_octant(octant))) << octant;
  for (int face = 0; face < kStarFaces; ++face) {
    Index3 step = step_of_octant(lower_octant(face));
    step[face / 4] = 0;
    mask |= static_cast<NewbornMask>(is_newborn(field, v, step)) << (8 + face);
  }
  return mask;
}

} // namespace

RC_GTEST_PROP(NewbornMasks, AreTheCellsAndFacesWhoseFirstCornerIsTheSample, ())
{
  const Field field = *random_field(7);
  for (std::int64_t z = 1; z + 1 < field.size[2]; ++z)
    for (std::int64_t y = 1; y + 1 < field.size[1]; ++y) {
      StarRows rows{};
      for (std::int64_t i = 0; i < 9; ++i)
        rows[static_cast<std::size_t>(i)] = field.values.data() + sample_at(field, {1, y + i % 3 - 1, z + i / 3 - 1});
      std::vector<NewbornMask> masks(static_cast<std::size_t>(field.size[0] - 2));
      newborn_masks(rows, field.size[0] - 2, masks.data());
      for (std::int64_t x = 1; x + 1 < field.size[0]; ++x)
        RC_ASSERT(masks[static_cast<std::size_t>(x - 1)] == naive_mask(field, {x, y, z}));
    }
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
