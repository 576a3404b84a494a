#include "volsurf/pipeline/hull.h"

#include "support/label_volumes.h"

#include <gtest/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

/// From the first cell to the last.
struct Box {
  Index3 first;
  Index3 last;
  float intensity;
};

bool holds(const Box &box, const Index3 &p)
{
  for (int axis = 0; axis < 3; ++axis)
    if (p[axis] < box.first[axis] || p[axis] > box.last[axis])
      return false;
  return true;
}

/// What is outside of the hull of boxes on a background of intensity 0: per box, in their order. Later boxes lie on
/// earlier ones.
std::vector<char> outside_among(const std::vector<Box> &boxes, float factor = 1)
{
  const Index3 size{24, 24, 24};
  const auto box_at = [&](const Index3 &p) { // 0: none
    BasinId found = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      found = holds(boxes[i], p) ? static_cast<BasinId>(i + 1) : found;
    return found;
  };
  const LabelledCells labels = label_cells(size, static_cast<BasinId>(boxes.size() + 1), box_at);
  Volume volume;
  volume.grid = grid_of(size);
  for_each_sample(volume.grid.size, [&](const Index3 &p, CellId) {
    const BasinId box = box_at(p);
    volume.samples.push_back(box == 0 ? 0 : factor * boxes[box - 1].intensity);
  });
  const auto outside = find_outside_of_hull(labels.cells, volume, regions_of(labels), 1);
  EXPECT_EQ(outside[1], 1) << "the background";
  return {outside.begin() + 2, outside.end()};
}

const Box kBody{{4, 4, 4}, {19, 19, 19}, 100};

} // namespace

TEST(OutsideOfHull, AFurrowWithAWallAtItsMouthIsOutside)
{
  const Box furrow{{11, 8, 6}, {13, 15, 19}, 10}; // its mouth is at z = 19
  EXPECT_EQ(outside_among({kBody, furrow}), (std::vector<char>{0, 1}));
  EXPECT_EQ(outside_among({kBody, furrow}, -3), (std::vector<char>{0, 1})) << "of a dark body on a bright background";
}

TEST(OutsideOfHull, ACavityIsInside)
{
  const Box cavity{{9, 9, 9}, {14, 14, 14}, 0};
  EXPECT_EQ(outside_among({kBody, cavity}), (std::vector<char>{0, 0}));
  const Box canal{{11, 11, 15}, {11, 11, 19}, 0};
  EXPECT_EQ(outside_among({kBody, cavity, canal}), (std::vector<char>{0, 0, 0})) << "and so is a narrow way into it";
}

TEST(OutsideOfHull, ADarkBodyOnTheBackgroundIsInside)
{
  const Box dark{{20, 8, 8}, {23, 15, 15}, 30};
  EXPECT_EQ(outside_among({kBody, dark}), (std::vector<char>{0, 0})) << "beside a bright one";
  EXPECT_EQ(outside_among({dark}), (std::vector<char>{0})) << "by itself";
}

TEST(OutsideOfHull, ABrightPartOfABodyIsInside)
{
  const Box part{{11, 8, 6}, {13, 15, 19}, 70};
  EXPECT_EQ(outside_among({kBody, part}), (std::vector<char>{0, 0}));
}
