#include "volsurf/surface/boundary.h"

#include "support/label_volumes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

using namespace volsurf;
using namespace volsurf::support;

namespace {

RegionId side_at(const LabelledCells &labels, const Sides &sides, const Index3 &cell)
{
  for (int axis = 0; axis < 3; ++axis)
    if (cell[axis] < 0 || cell[axis] >= labels.cells.size[axis])
      return sides.outside;
  return sides.of_basin[labels.at(cell)];
}

/// Whether (axis, lowest corner) is a face of the volume: it ends within it.
bool is_face(const Index3 &cells, int axis, const Index3 &p)
{
  for (int other = 0; other < 3; ++other)
    if (other != axis && p[other] == cells[other])
      return false;
  return true;
}

} // namespace

RC_GTEST_PROP(FindBoundary, HoldsTheFacesWhoseTwoCellsLieOnDifferentSides, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 5, 4);
  const Sides sides = dice.one_in(2) ? all_sides(labels) : hull_sides(labels);
  const FaceSet faces = find_boundary(labels.cells, sides);
  FaceIndex count = 0;
  for_each_sample(faces.samples(), [&](const Index3 &p, SampleId) {
    for (int axis = 0; axis < 3; ++axis) {
      Index3 lower = p;
      --lower[axis];
      const bool separates =
          is_face(labels.cells.size, axis, p) && side_at(labels, sides, lower) != side_at(labels, sides, p);
      RC_ASSERT(faces.contains(axis, p[0], p[1], p[2]) == separates);
      count += separates ? 1 : 0;
    }
  });
  RC_ASSERT(faces.size() == count);
}

TEST(FindBoundary, SeesTheLastCellsOfRowsLongerThanAWord)
{
  for (const std::int64_t length : {63, 64, 65, 127, 128, 129, 200})
    for (const std::int64_t x : {std::int64_t{0}, std::int64_t{62}, length - 1}) {
      const LabelledCells labels = label_cells({length, 2, 2}, 2, [&](const Index3 &p) {
        return p == Index3{x, 1, 0} ? 1U : 0U;
      });
      EXPECT_EQ(find_boundary(labels.cells, all_sides(labels)).size(), 6U) << length << ' ' << x;
    }
}

RC_GTEST_PROP(FaceSet, NumbersItsFacesInTheOrderThatItVisitsThem, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 5, 3);
  const FaceSet faces = find_boundary(labels.cells, all_sides(labels));
  FaceIndex expected = 0;
  for (std::int64_t z = 0; z < faces.samples()[2]; ++z) {
    RC_ASSERT(faces.faces_before_plane(z) == expected);
    faces.for_each(z, z + 1, [&](FaceIndex index, const FacePosition &face) {
      const auto &[x, y, fz] = face.corner;
      RC_ASSERT(fz == z);
      RC_ASSERT(index == expected++);
      RC_ASSERT(faces.contains(face.axis, x, y, z));
      RC_ASSERT(faces.index_of(face.axis, x, y, z) == index);
    });
  }
  RC_ASSERT(faces.size() == expected);
  RC_ASSERT(faces.faces_before_plane(faces.samples()[2]) == expected);
}
