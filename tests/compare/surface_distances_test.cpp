// Distances whose values are known, and laws that hold for all surfaces.
#include "support/solids.h"
#include "volsurf/compare/surface_distances.h"
#include "volsurf/compare/surface_samples.h"
#include "volsurf/core/parallel.h"

#include <gtest/gtest.h>

#include <limits>

namespace volsurf::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kCuts = 5; // 8192 triangles; on a sphere of radius 10 none is more than 0.01 inside
constexpr double kFacetError = 0.015;

constexpr std::int64_t kSamples = 60000;

const Vec3 kOrigin{0, 0, 0};

SurfaceDistances measured(const Mesh &a, const Mesh &b, double tolerance_mm = 1)
{
  return measure_distances(a, b, {tolerance_mm, kSamples});
}

TEST(SurfaceDistances, BetweenConcentricSpheresAreTheDifferenceOfTheirRadii)
{
  const SurfaceDistances d = measured(sphere_mesh(kOrigin, 11, kCuts), sphere_mesh(kOrigin, 10, kCuts), 1.1);
  for (const double value : {d.assd_mm, d.rms_mm, d.hd95_mm, d.hausdorff_mm, d.a_to_b.mean_mm, d.b_to_a.mean_mm,
                             d.a_to_b.maximum_mm, d.b_to_a.percentile95_mm, d.bias_mm})
    EXPECT_NEAR(value, 1, kFacetError);
  EXPECT_NEAR(d.a_to_b.signed_mean_mm, 1, kFacetError) << "the larger one lies outside";
  EXPECT_NEAR(d.b_to_a.signed_mean_mm, -1, kFacetError);
  EXPECT_EQ(d.surface_dice, 1);
}

TEST(SurfaceDistances, SurfaceDiceCountsTheAreaWithinTheTolerance)
{
  const Mesh a = sphere_mesh(kOrigin, 11, kCuts);
  const Mesh b = sphere_mesh(kOrigin, 10, kCuts);
  EXPECT_EQ(measured(a, b, 1.1).surface_dice, 1);
  EXPECT_EQ(measured(a, b, 0.9).surface_dice, 0);
  // One of two spheres has a counterpart: half of that side's area agrees.
  const Mesh two = joined(b, sphere_mesh({40, 0, 0}, 10, kCuts));
  const SurfaceDistances d = measured(two, b, 0.5);
  EXPECT_NEAR(d.a_to_b.area_within, 0.5, 1e-6);
  EXPECT_NEAR(d.b_to_a.area_within, 1, 1e-6);
  EXPECT_NEAR(d.surface_dice, (0.5 * 2 + 1) / 3, 1e-6);
}

TEST(SurfaceDistances, BetweenShiftedSpheresFollowTheCosine)
{
  constexpr double kRadius = 10;
  constexpr double kShift = 2;
  double mean = 0; // over the sphere, area is uniform in the cosine
  double square = 0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = -1 + (i + 0.5) * 2 / kSteps;
    const double distance =
        std::abs(std::sqrt(kRadius * kRadius + kShift * kShift - 2 * kRadius * kShift * cosine) - kRadius);
    mean += distance / kSteps;
    square += distance * distance / kSteps;
  }
  const SurfaceDistances d =
      measured(sphere_mesh(kOrigin, kRadius, kCuts), sphere_mesh({kShift, 0, 0}, kRadius, kCuts));
  EXPECT_NEAR(d.assd_mm, mean, kFacetError);
  EXPECT_NEAR(d.rms_mm, std::sqrt(square), kFacetError);
  EXPECT_NEAR(d.hausdorff_mm, kShift, kFacetError);
  EXPECT_NEAR(d.bias_mm, 0, 1e-3);
}

TEST(SurfaceDistances, BetweenBoxesAreThoseWorkedOutByHand)
{
  // A cube of side 2 in the middle of one of side 4. From inside out every point is 1 away. From outside in, over one
  // face: 1 above the inner face (a quarter of the area), hypot(1, u) above a strip, hypot(1, u, v) at the corners.
  const Mesh inner = box_mesh({-1, -1, -1}, {1, 1, 1});
  const Mesh outer = box_mesh({-2, -2, -2}, {2, 2, 2});
  double strip = 0;
  double corner = 0;
  constexpr int kSteps = 400;
  for (int i = 0; i < kSteps; ++i) {
    strip += std::hypot(1, (i + 0.5) / kSteps) / kSteps;
    for (int j = 0; j < kSteps; ++j)
      corner += std::hypot(1, (i + 0.5) / kSteps, (j + 0.5) / kSteps) / (kSteps * kSteps);
  }
  const SurfaceDistances d = measured(inner, outer);
  EXPECT_NEAR(d.a_to_b.mean_mm, 1, 1e-9);
  EXPECT_NEAR(d.a_to_b.maximum_mm, 1, 1e-9);
  EXPECT_NEAR(d.a_to_b.signed_mean_mm, -1, 1e-9);
  EXPECT_NEAR(d.b_to_a.mean_mm, (1 + 2 * strip + corner) / 4, 5e-4);
  EXPECT_NEAR(d.hausdorff_mm, std::sqrt(3.0), 1e-6) << "at the corners, which no sample hits";
  EXPECT_NEAR(d.assd_mm, (24 * d.a_to_b.mean_mm + 96 * d.b_to_a.mean_mm) / 120, 1e-9) << "weighted by area";
}

TEST(SurfaceDistances, OfASurfaceFromItselfAreZero)
{
  const Mesh mesh = sphere_mesh({100, -50, 30}, 10, 4);
  const SurfaceDistances d = measured(mesh, mesh, 0.001);
  for (const double value : {d.assd_mm, d.rms_mm, d.hd95_mm, d.hausdorff_mm})
    EXPECT_LT(value, 1e-12);
  EXPECT_EQ(d.surface_dice, 1);
}

TEST(SurfaceDistances, SwappedSurfacesSwapDirections)
{
  const Mesh a = sphere_mesh(kOrigin, 10, 4);
  const Mesh b = box_mesh({-8, -9, -7}, {8, 6, 10});
  const SurfaceDistances d = measured(a, b);
  const SurfaceDistances e = measured(b, a);
  EXPECT_EQ(d.a_to_b.mean_mm, e.b_to_a.mean_mm);
  EXPECT_EQ(d.a_to_b.maximum_mm, e.b_to_a.maximum_mm);
  EXPECT_DOUBLE_EQ(d.assd_mm, e.assd_mm);
  EXPECT_EQ(d.hd95_mm, e.hd95_mm);
  EXPECT_DOUBLE_EQ(d.surface_dice, e.surface_dice);
  EXPECT_DOUBLE_EQ(d.bias_mm, -e.bias_mm);
}

TEST(SurfaceDistances, StayUnderRigidMotionAndGrowWithScale)
{
  const Mesh a = sphere_mesh(kOrigin, 10, 4);
  const Mesh b = box_mesh({-8, -9, -7}, {8, 6, 10});
  const SurfaceDistances before = measured(a, b, 1);
  for (const double scale : {1.0, 7.0}) {
    const auto move = [&](const Mesh &mesh) { return moved(mesh, skew_rotation(), {100, -70, 30}, scale); };
    const SurfaceDistances after = measured(move(a), move(b), scale);
    EXPECT_NEAR(after.assd_mm, scale * before.assd_mm, 2e-5 * scale);
    EXPECT_NEAR(after.rms_mm, scale * before.rms_mm, 2e-5 * scale);
    EXPECT_NEAR(after.hd95_mm, scale * before.hd95_mm, 1e-3 * scale);
    EXPECT_NEAR(after.hausdorff_mm, scale * before.hausdorff_mm, 1e-4 * scale);
    EXPECT_NEAR(after.bias_mm, scale * before.bias_mm, 2e-5 * scale);
    EXPECT_NEAR(after.surface_dice, before.surface_dice, 1e-4);
  }
}

TEST(SurfaceDistances, DoNotDependOnTheTessellation)
{
  const Mesh sphere = sphere_mesh(kOrigin, 10, 3);
  const Mesh coarse = box_mesh({-8, -9, -7}, {8, 6, 10});
  Mesh uneven = coarse; // one half of it far finer than the other: means over vertices would follow that half
  for (int i = 0; i < 4; ++i)
    uneven = cut_in_four(uneven);
  Mesh half = coarse;
  half.triangles.resize(6);
  uneven.triangles.erase(uneven.triangles.begin(), uneven.triangles.begin() + 6 * 256);
  uneven = joined(half, uneven);
  const SurfaceDistances d = measured(coarse, sphere);
  const SurfaceDistances e = measured(uneven, sphere);
  EXPECT_NEAR(d.a_to_b.mean_mm, e.a_to_b.mean_mm, 1e-3);
  EXPECT_NEAR(d.a_to_b.rms_mm, e.a_to_b.rms_mm, 1e-3);
  EXPECT_NEAR(d.a_to_b.percentile95_mm, e.a_to_b.percentile95_mm, 5e-3);
  EXPECT_NEAR(d.a_to_b.area_within, e.a_to_b.area_within, 1e-3);
  EXPECT_NEAR(d.b_to_a.mean_mm, e.b_to_a.mean_mm, 1e-9) << "the same surface to measure to";
}

TEST(SurfaceDistances, AreTheSameForAnyNumberOfThreads)
{
  const Mesh a = sphere_mesh(kOrigin, 10, 4);
  const Mesh b = sphere_mesh({1, 2, 0.5}, 9, 4);
  const auto measured_on = [&](int threads) {
    const ThreadLimit limit(threads);
    return measured(a, b);
  };
  const SurfaceDistances one = measured_on(1);
  const SurfaceDistances two = measured_on(2);
  EXPECT_EQ(one.assd_mm, two.assd_mm);
  EXPECT_EQ(one.bias_mm, two.bias_mm);
  EXPECT_EQ(one.a_to_b.at_vertices_mm, two.a_to_b.at_vertices_mm);
}

TEST(SurfaceSamples, SumUpToTheAreaAndReachEveryTriangle)
{
  const Mesh mesh = joined(sphere_mesh(kOrigin, 10, 2), box_mesh({20, 0, 0}, {20.01, 0.01, 0.01}));
  const SurfaceSamples samples = sample_surface(mesh, 1000);
  double area = 0;
  int in_the_tiny_box = 0;
  for (std::size_t i = 0; i < samples.positions.size(); ++i) {
    area += samples.areas_mm2[i];
    in_the_tiny_box += samples.positions[i][0] > 15 ? 1 : 0;
  }
  EXPECT_NEAR(area, surface_area_mm2(mesh), 1e-9 * area);
  EXPECT_NEAR(surface_area_mm2(sphere_mesh(kOrigin, 10, kCuts)), 4 * kPi * 100, 2);
  EXPECT_EQ(in_the_tiny_box, 12);
}

TEST(SurfaceSamples, IntegrateOverATriangle)
{
  // Over the triangle with corners (0,0), (1,0), (0,1): mean of x is 1/3, of x^2 and x y 1/6 and 1/12.
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  for (const int count : {64, 1000}) {
    const SurfaceSamples samples = sample_surface(mesh, count);
    EXPECT_EQ(samples.positions.size(), static_cast<std::size_t>(count));
    double x = 0;
    double x2 = 0;
    double xy = 0;
    for (const Vec3 &p : samples.positions) {
      x += p[0] / count;
      x2 += p[0] * p[0] / count;
      xy += p[0] * p[1] / count;
    }
    EXPECT_NEAR(x, 1.0 / 3, count == 64 ? 1e-12 : 2e-3) << "64 = 4^3 is a regular subdivision";
    EXPECT_NEAR(x2, 1.0 / 6, 2e-3);
    EXPECT_NEAR(xy, 1.0 / 12, 2e-3);
  }
}

} // namespace
} // namespace volsurf::test
