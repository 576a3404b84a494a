// Shapes and what is measured between them, and the demands that can be made on it.
#include "support/contains.h"
#include "support/solids.h"
#include "volsurf/core/error.h"
#include "volsurf/pipeline/comparison.h"
#include "volsurf/pipeline/metrics.h"

#include <gtest/gtest.h>

#include <set>

namespace volsurf::test {
namespace {

/// 1 within `radius` of the middle of a cube of 1 mm voxels, 40 to a side; 2 beyond.
Volume ball_labels(double radius)
{
  Volume volume;
  volume.grid.size = {40, 40, 40};
  volume.grid.origin_mm = {-19.5, -19.5, -19.5};
  for (int z = 0; z < 40; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x)
        volume.samples.push_back(std::hypot(x - 19.5, y - 19.5, z - 19.5) <= radius ? 1.0F : 2.0F);
  return volume;
}

double value_of(const std::string &name, const Comparison &comparison)
{
  for (const Metric &metric : metrics())
    if (metric.name == name)
      return metric.value(comparison).value_or(-1000);
  return -2000;
}

Comparison compared(const Shape &a, const Shape &b)
{
  ComparisonOptions options;
  options.samples = 60000;
  return compare(a, b, options);
}

TEST(Comparison, OfABallWithItsLabelsIsWithinTheVoxels)
{
  const Shape ball = shape_of_surface(sphere_mesh({0, 0, 0}, 12, 4));
  const Shape labels = shape_of_labels(ball_labels(12), {1});
  const Comparison c = compared(ball, labels);
  EXPECT_EQ(c.tolerance_mm, 1) << "a voxel";
  EXPECT_LT(c.distances.assd_mm, 0.3);
  EXPECT_LT(c.distances.hausdorff_mm, 1);
  EXPECT_NEAR(c.distances.bias_mm, 0, 0.05);
  EXPECT_GT(c.overlap->dice, 0.99);
  EXPECT_NEAR(*c.volume_a_mm3 / *c.volume_b_mm3, 1, 0.01);
  const Comparison back = compared(labels, ball);
  EXPECT_EQ(back.overlap->samples_a, c.overlap->samples_b);
  EXPECT_EQ(back.overlap->dice, c.overlap->dice);
}

TEST(Comparison, OfLabelsOnOneLatticeCountsVoxels)
{
  const Shape large = shape_of_labels(ball_labels(12), {1});
  const Shape small = shape_of_labels(ball_labels(10), {1});
  const Comparison c = compared(small, large);
  EXPECT_EQ(static_cast<double>(c.overlap->samples_a), *c.volume_a_mm3);
  EXPECT_EQ(c.overlap->samples_both, c.overlap->samples_a);
  EXPECT_NEAR(value_of("volume_error", c), std::pow(10.0 / 12, 3) - 1, 0.01);
  EXPECT_NEAR(c.distances.bias_mm, -2, 0.25) << "the smaller one lies inside";
}

TEST(Comparison, OfLabelsOnTwoLatticesGoesBySurfaces)
{
  Volume shifted = ball_labels(12);
  shifted.grid.origin_mm = {-19.2, -19.5, -19.5};
  const Comparison c = compared(shape_of_labels(ball_labels(12), {1}), shape_of_labels(shifted, {1}));
  EXPECT_LT(c.overlap->spacing_mm[0], 0.2);
  EXPECT_GT(c.overlap->dice, 0.97);
  EXPECT_LT(c.overlap->dice, 0.99);
}

TEST(Comparison, OfAnOpenSurfaceLeavesOutWhatNeedsAnInside)
{
  Mesh open = sphere_mesh({0, 0, 0}, 12, 4);
  open.triangles.pop_back();
  const Comparison c = compared(shape_of_surface(open), shape_of_surface(sphere_mesh({0, 0, 0}, 12, 4)));
  EXPECT_FALSE(c.overlap.has_value());
  ASSERT_EQ(c.warnings.size(), 1U);
  EXPECT_TRUE(contains(c.warnings[0], "A is not closed (3 edges"));
  for (const std::string name : {"dice", "jaccard", "volume_a", "volume_error", "bias", "bias_b_to_a"})
    EXPECT_EQ(value_of(name, c), -1000) << name;
  EXPECT_NEAR(value_of("bias_a_to_b", c), 0, 1e-6) << "b has an inside";
  EXPECT_LT(c.distances.assd_mm, 1e-3);
}

TEST(Comparison, WarnsOfBodiesInDifferentFrames)
{
  const Comparison c =
      compared(shape_of_surface(sphere_mesh({50, 30, 0}, 12, 3)), shape_of_surface(sphere_mesh({-50, -30, 0}, 12, 3)));
  ASSERT_EQ(c.warnings.size(), 1U);
  EXPECT_TRUE(contains(c.warnings[0], "do not meet"));
  EXPECT_TRUE(contains(c.warnings[0], "RAS"));
  const Comparison far =
      compared(shape_of_surface(sphere_mesh({50, 0, 0}, 12, 3)), shape_of_surface(sphere_mesh({0, 0, 90}, 12, 3)));
  ASSERT_EQ(far.warnings.size(), 1U);
  EXPECT_FALSE(far.warnings[0].find("RAS") != std::string::npos);
}

TEST(Shape, OfASoupOfTrianglesIsClosedOncePointsAreShared)
{
  const Shape shape = shape_of_surface(cut_in_four(box_mesh({0, 0, 0}, {2, 3, 4})));
  EXPECT_TRUE(shape.is_closed());
  EXPECT_NEAR(*shape.volume_mm3, 24, 1e-6);
}

TEST(Shape, TurnsNormalsOutwards)
{
  Mesh mesh = box_mesh({0, 0, 0}, {2, 3, 4});
  for (Triangle &t : mesh.triangles)
    std::swap(t[0], t[1]);
  const Shape inside_out = shape_of_surface(mesh);
  EXPECT_NEAR(*inside_out.volume_mm3, 24, 1e-6);
  EXPECT_NEAR(compared(shape_of_surface(box_mesh({-1, -1, -1}, {3, 4, 5})), inside_out).distances.a_to_b.signed_mean_mm,
              1.1, 0.1);
}

TEST(Shape, RefusesWhatHasNoSurface)
{
  Mesh flat;
  flat.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 2}};
  EXPECT_THROW(shape_of_surface(flat), InputError);
  EXPECT_THROW(shape_of_labels(ball_labels(5), {7}), InputError);
}

TEST(Metrics, HaveNamesOfTheirOwn)
{
  std::set<std::string> names;
  for (const Metric &metric : metrics())
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
}

TEST(Requirement, IsReadWithEachRelation)
{
  Comparison c;
  c.distances.assd_mm = 0.5;
  for (const std::string met : {"assd<0.51", "assd <= 0.5", "assd>.4", " assd >= 5e-1"})
    EXPECT_TRUE(is_met(parse_requirement(met), c)) << met;
  for (const std::string missed : {"assd<0.5", "assd<=0.4999", "assd>0.5", "assd>=1"})
    EXPECT_FALSE(is_met(parse_requirement(missed), c)) << missed;
}

TEST(Requirement, OnWhatHasNoValueIsNotMet)
{
  EXPECT_FALSE(is_met(parse_requirement("dice>=0"), Comparison()));
  EXPECT_FALSE(is_met(parse_requirement("bias<100"), Comparison()));
}

TEST(Requirement, ThatCannotBeMeantIsRefused)
{
  for (const std::string text : {"", "assd", "assd=0.3", "assd<", "assd<x", "<3", "assd<nan", "nonsense<3", "assd<3 4"})
    EXPECT_THROW(parse_requirement(text), UsageError) << text;
}

} // namespace
} // namespace volsurf::test
