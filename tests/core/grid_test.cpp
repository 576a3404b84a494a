#include "volsurf/core/grid.h"

#include "support/fields.h"
#include "support/grids.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

void require_near(const Vec3 &a, const Vec3 &b, double tolerance)
{
  for (int axis = 0; axis < 3; ++axis)
    RC_ASSERT(std::abs(a[axis] - b[axis]) <= tolerance);
}

} // namespace

RC_GTEST_PROP(Grid, WorldToIndexUndoesIndexToWorld, ())
{
  Dice dice(*random_seed());
  const Grid grid = any_grid(dice);
  Vec3 index{};
  for (double &coordinate : index)
    coordinate = 0.25 * static_cast<double>(dice.between(-40, 400));
  require_near(world_to_index(grid, index_to_world(grid, index)), index, 1e-9);
}

RC_GTEST_PROP(Grid, AStepAlongAnAxisIsItsColumnTimesItsSpacing, ())
{
  Dice dice(*random_seed());
  const Grid grid = any_grid(dice);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 index{1, 2, 3};
    const Vec3 from = index_to_world(grid, index);
    ++index[axis];
    const Vec3 to = index_to_world(grid, index);
    for (int row = 0; row < 3; ++row)
      RC_ASSERT(std::abs(to[row] - from[row] - grid.direction[row][axis] * grid.spacing_mm[axis]) < 1e-9);
  }
}

RC_GTEST_PROP(Grid, CellCentresLieHalfAVoxelIntoTheGrid, ())
{
  Dice dice(*random_seed());
  const Grid grid = any_grid(dice);
  const Grid cells = cell_centre_grid(grid);
  RC_ASSERT(cells.size == grid.cell_size());
  RC_ASSERT(cells.sample_count() == grid.cell_count());
  require_near(index_to_world(cells, {2, 0, 1}), index_to_world(grid, {2.5, 0.5, 1.5}), 1e-9);
}

RC_GTEST_PROP(Grid, VoxelCornersAreHalfAVoxelAroundTheSamples, ())
{
  Dice dice(*random_seed());
  const Grid grid = any_grid(dice);
  const Grid corners = voxel_corner_grid(grid);
  RC_ASSERT(corners.cell_size() == grid.size);
  require_near(index_to_world(corners, {2, 0, 1}), index_to_world(grid, {1.5, -0.5, 0.5}), 1e-9);
  require_near(cell_centre_grid(corners).origin_mm, grid.origin_mm, 1e-9);
}

TEST(Grid, MirroringOneAxisMakesItLeftHanded)
{
  Grid grid;
  EXPECT_FALSE(is_mirrored(grid));
  grid.direction[1][1] = -1;
  EXPECT_TRUE(is_mirrored(grid));
  grid.direction[0][0] = -1;
  EXPECT_FALSE(is_mirrored(grid));
}

TEST(Grid, VoxelVolumeIsTheProductOfTheSpacings)
{
  Grid grid;
  grid.spacing_mm = {0.5, 2, 3};
  EXPECT_DOUBLE_EQ(voxel_volume_mm3(grid), 3);
  EXPECT_DOUBLE_EQ(smallest_spacing_mm(grid), 0.5);
}

TEST(Grid, ACubeOfTheMeanSpacingIsAsLargeAsAVoxel)
{
  Grid grid;
  grid.spacing_mm = {0.6, 0.6, 1.5};
  EXPECT_NEAR(std::pow(mean_spacing_mm(grid), 3), voxel_volume_mm3(grid), 1e-12);
  for (const double spacing : {1.0, 2.0 / 15, 0.1}) {
    grid.spacing_mm = {spacing, spacing, spacing};
    EXPECT_EQ(mean_spacing_mm(grid), spacing) << "to the last bit";
  }
}
