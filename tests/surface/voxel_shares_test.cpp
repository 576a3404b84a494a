#include "volsurf/surface/voxel_shares.h"

#include "support/box_mesh.h"
#include "support/label_volumes.h"

#include "volsurf/core/parallel.h"
#include "volsurf/surface/check.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

using namespace volsurf;
using namespace volsurf::support;

namespace {

/// The part of 0 .. 1 around a sample that an interval covers.
double covered(double low, double high, std::int64_t sample)
{
  const double centre = static_cast<double>(sample);
  return std::max(0.0, std::min(high, centre + 0.5) - std::max(low, centre - 0.5));
}

} // namespace

TEST(VoxelShares, AreThePartsOfABox)
{
  const Vec3 low{1.3, 1.7, 2.0};
  const Vec3 high{5.9, 4.2, 5.6};
  const Grid grid = cube(8);
  const std::vector<float> shares = voxel_shares(box(low, high), grid);
  for_each_sample(grid.size, [&](const Index3 &p, SampleId sample) {
    const double exact =
        covered(low[0], high[0], p[0]) * covered(low[1], high[1], p[1]) * covered(low[2], high[2], p[2]);
    EXPECT_NEAR(shares[static_cast<std::size_t>(sample)], exact, 1.0 / 16) << p[0] << ' ' << p[1] << ' ' << p[2];
  });
}

TEST(VoxelShares, OfAWindowAreThoseOfTheWhole)
{
  const Mesh mesh = box({1.3, 1.7, 2.1}, {5.9, 4.2, 5.6});
  const Grid grid = cube(8);
  Grid window = grid;
  window.size = {4, 5, 6};
  window.origin_mm = {2, 1, 2};
  constexpr std::int64_t kPadding = 3;
  const std::vector<float> whole = voxel_shares(mesh, grid);
  const std::vector<float> part = voxel_shares(mesh, window, kPadding);
  for_each_sample({4 + 2 * kPadding, 5, 6}, [&](const Index3 &p, SampleId sample) {
    const std::int64_t x = p[0] - kPadding;
    const bool is_padding = x < 0 || x >= 4;
    const auto in_whole = static_cast<std::size_t>(x + 2 + 8 * (p[1] + 1 + 8 * (p[2] + 2)));
    EXPECT_NEAR(part[static_cast<std::size_t>(sample)], is_padding ? 0 : whole[in_whole], 1e-6);
  });
}

RC_GTEST_PROP(VoxelShares, AddUpToTheEnclosedVolume, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 6, 3);
  const Grid grid = grid_of(labels.cells.size);
  const Mesh mesh = mesh_of(labels, grid, hull_sides(labels), true);
  const std::vector<float> shares = voxel_shares(mesh, grid);
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  RC_ASSERT(std::abs(sum - signed_volume_mm3(mesh)) < 1e-4 * (1 + sum));
  for (const float share : shares)
    RC_ASSERT(share >= 0 && share <= 1);
  const ThreadLimit limit(1);
  RC_ASSERT(voxel_shares(mesh, grid) == shares);
}
