#include "volsurf/surface/refine.h"

#include "support/label_volumes.h"

#include "volsurf/core/vec3.h"
#include "volsurf/surface/check.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

using namespace volsurf;
using namespace volsurf::support;

namespace {

double longest_edge(const Mesh &mesh)
{
  double longest = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      longest = std::max(longest, length(minus(corner(mesh, t, i), corner(mesh, t, (i + 1) % 3))));
  return longest;
}

/// The sum of the triangles' normals, as long as twice their areas, and of their areas, for each value of the arrays.
using Sums = std::map<std::array<double, 5>, std::array<double, 4>>;

Sums sums_of(const Mesh &mesh)
{
  Sums sums;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 normal = doubled_area_normal(mesh, t);
    auto &sum = sums[{static_cast<double>(mesh.region_a[t]), static_cast<double>(mesh.region_b[t]),
                      static_cast<double>(mesh.persistence[t]), static_cast<double>(mesh.component[t]),
                      static_cast<double>(mesh.cap[t])}];
    for (int axis = 0; axis < 3; ++axis)
      sum[axis] += normal[axis];
    sum[3] += length(normal);
  }
  return sums;
}

Mesh stretched_mesh(Dice &dice)
{
  const LabelledCells labels = random_cells(dice, 4, 3);
  Grid grid = grid_of(labels.cells.size);
  grid.spacing_mm = {1, 1, static_cast<double>(dice.between(1, 5))};
  return mesh_of(labels, grid, all_sides(labels), false);
}

std::pair<Mesh, Mesh> before_and_after(std::uint64_t seed)
{
  Dice dice(seed);
  const Mesh before = stretched_mesh(dice);
  Mesh after = before;
  halve_long_edges(after, 1.5);
  return {before, after};
}

} // namespace

RC_GTEST_PROP(HalveLongEdges, KeepsTheSurfaceItsSidesAndItsArrays, ())
{
  const auto [before, after] = before_and_after(*random_seed());
  const Sums expected = sums_of(before);
  const Sums found = sums_of(after);
  RC_ASSERT(found.size() == expected.size());
  for (const auto &[arrays, sum] : expected)
    for (std::size_t i = 0; i < sum.size(); ++i)
      RC_ASSERT(std::abs(found.at(arrays)[i] - sum[i]) < 1e-4);
}

RC_GTEST_PROP(HalveLongEdges, OpensNothingAndMakesNoNewJunctionsOfPoints, ())
{
  const auto [before, after] = before_and_after(*random_seed());
  const auto expected = check_mesh(before);
  const auto found = check_mesh(after);
  RC_ASSERT(found.open_edges == expected.open_edges);
  RC_ASSERT(found.watertight == expected.watertight);
  RC_ASSERT(found.euler_characteristic == expected.euler_characteristic);
  RC_ASSERT(std::equal(before.points.begin(), before.points.end(), after.points.begin()));
}

RC_GTEST_PROP(HalveLongEdges, LeavesNoLongEdgeButWhatItMayNotHalveAgain, ())
{
  Dice dice(*random_seed());
  Mesh mesh = stretched_mesh(dice);
  const double before = longest_edge(mesh);
  halve_long_edges(mesh, 2);
  RC_ASSERT(longest_edge(mesh) <= std::max(2.0, before / (1 << kMostHalvings)) + 1e-6);
}

TEST(HalveLongEdges, LeavesShortEdgesAlone)
{
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  halve_long_edges(mesh, 1.5);
  EXPECT_EQ(mesh.points.size(), 3U);
  halve_long_edges(mesh, 1.2); // the one diagonal
  EXPECT_EQ(mesh.points.size(), 4U);
  EXPECT_EQ(mesh.triangles.size(), 2U);
}
