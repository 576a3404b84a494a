#include "volsurf/field/edge_locator.h"

#include "support/partial_volumes.h"

#include "volsurf/field/noise_level.h"
#include "volsurf/phantom/noise.h"

#include <gtest/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr std::int64_t kSize = 40;
constexpr double kNoise = 1; ///< of the gradient

/// A body of 100 in an emptiness of 20.
template <typename Distance> Volume body(Distance distance)
{
  constexpr int kParts = 6;
  return scan_of_body({kSize, kSize, kSize}, distance, 20, 100, kParts);
}

const Vec3 kCentre{19.3, 20.1, 19.8};

double distance_to_ball(const Vec3 &p, double radius)
{
  return std::hypot(p[0] - kCentre[0], p[1] - kCentre[1], p[2] - kCentre[2]) - radius;
}

Vec3 along(const Vec3 &start, const Vec3 &direction, double way)
{
  return {start[0] + way * direction[0], start[1] + way * direction[1], start[2] + way * direction[2]};
}

const std::array<Vec3, 4> kDirections{Vec3{1, 0, 0}, Vec3{0, 0.6, -0.8}, Vec3{-0.48, 0.6, 0.64},
                                      Vec3{0.57735, 0.57735, 0.57735}};

} // namespace

TEST(EdgeLocator, FindsAPlaneBetweenTheSamples)
{
  const EdgeLocator locator(body([](const Vec3 &p) { return 0.8 * p[0] + 0.6 * p[1] - 27.37; }), 1.0, kNoise);
  const Vec3 normal{0.8, 0.6, 0};
  for (const double off : {-1.2, -0.4, 0.0, 0.3, 1.1}) {
    const auto edge = locator.find(along({19.496, 19.6216, 20}, normal, off), normal, 1.5);
    ASSERT_TRUE(edge.has_value()) << off;
    EXPECT_NEAR(edge->way_mm + off, 0, 0.02) << off;
  }
}

TEST(EdgeLocator, IsHardlyBiasedByCurvature)
{
  constexpr int kDirections = 200;
  for (const double radius : {6.0, 14.0})
    for (const double sigma : {1.0, 1.5}) {
      const EdgeLocator locator(body([&](const Vec3 &p) { return distance_to_ball(p, radius); }), sigma, kNoise);
      double sum = 0;
      for (int i = 0; i < kDirections; ++i) {
        const double z = 2 * (i + 0.5) / kDirections - 1; // a spiral from pole to pole
        const double turn = 2.39996 * i;
        const Vec3 direction{std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z};
        const auto edge = locator.find(along(kCentre, direction, radius + 0.3), direction, 1.5);
        ASSERT_TRUE(edge.has_value());
        sum += edge->way_mm + 0.3;
      }
      const double bias_of_maximum = sigma * sigma / radius;
      EXPECT_NEAR(sum / kDirections, 0, 0.2 * bias_of_maximum) << "radius " << radius << ", sigma " << sigma;
    }
}

TEST(EdgeLocator, FindsTheSameEdgeFromInsideAndFromOutside)
{
  const EdgeLocator locator(body([](const Vec3 &p) { return distance_to_ball(p, 12); }), 1.0, kNoise);
  for (const Vec3 &direction : kDirections) {
    const Vec3 place = along(kCentre, direction, 12.3);
    const auto outwards = locator.find(place, direction, 1.5);
    const auto inwards = locator.find(place, {-direction[0], -direction[1], -direction[2]}, 1.5);
    ASSERT_TRUE(outwards && inwards);
    EXPECT_NEAR(outwards->way_mm, -inwards->way_mm, 1e-9);
    EXPECT_NEAR(outwards->error_mm, inwards->error_mm, 1e-9);
  }
}

TEST(EdgeLocator, FindsNothingBeyondItsLimit)
{
  const EdgeLocator locator(body([](const Vec3 &p) { return distance_to_ball(p, 12); }), 1.0, kNoise);
  EXPECT_FALSE(locator.find(along(kCentre, {1, 0, 0}, 13.2), {1, 0, 0}, 1.0));
  EXPECT_TRUE(locator.find(along(kCentre, {1, 0, 0}, 13.2), {1, 0, 0}, 1.5));
}

TEST(EdgeLocator, TakesDirectionsAndWaysInMillimetres)
{
  Volume volume = body([](const Vec3 &p) { return p[2] - 20.25; });
  volume.grid.spacing_mm = {0.5, 0.5, 2};
  const EdgeLocator locator(volume, 1.0, kNoise);
  const auto edge = locator.find({20, 20, 20}, {0, 0, 1}, 3);
  ASSERT_TRUE(edge.has_value());
  EXPECT_NEAR(edge->way_mm, 0.25 * 2, 0.2); // a tenth of a voxel
}

TEST(EdgeLocator, TellsHowFarNoiseMovesAnEdge)
{
  const Vec3 normal{0.8, 0.6, 0};
  const Volume clean = body([](const Vec3 &p) { return 0.8 * p[0] + 0.6 * p[1] - 27.37; });
  for (const double sigma : {0.8, 1.2}) {
    double squared = 0;
    double expected = 0;
    int edges = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      Volume volume = clean;
      NoiseOptions noise = parse_noise("gaussian:10%", 80);
      noise.seed = seed;
      add_noise(volume, noise);
      FieldOptions field;
      field.sigma_mm = sigma;
      const EdgeLocator locator(volume, sigma, measure_noise(volume, EdgeField(volume, field)).gradient);
      for (double z = 6; z < 34; z += 2)
        for (double away = -10; away <= 10; away += 2) {
          const Vec3 place{19.496 - 0.6 * away, 19.6216 + 0.8 * away, z};
          const auto edge = locator.find(place, normal, 1.5);
          ASSERT_TRUE(edge.has_value());
          squared += edge->way_mm * edge->way_mm;
          expected += edge->error_mm * edge->error_mm;
          ++edges;
        }
    }
    EXPECT_NEAR(std::sqrt(squared / expected), 1, 0.35) << "sigma " << sigma << ", " << edges << " edges";
  }
}

TEST(EdgeLocator, IsSureWithoutNoise)
{
  const EdgeLocator locator(body([](const Vec3 &p) { return p[0] - 20.25; }), 1.0, 0.0);
  const auto edge = locator.find({20, 20, 20}, {1, 0, 0}, 1.5);
  ASSERT_TRUE(edge.has_value());
  EXPECT_EQ(edge->error_mm, 0);
}

TEST(EdgeLocator, FindsNothingWhereAllIsFlat)
{
  const EdgeLocator locator(body([](const Vec3 &p) { return p[0] - 20.25; }), 1.0, 0.0);
  for (double x = 22; x < 30; x += 0.1) {
    const auto edge = locator.find({x, 20, 20}, {-1, 0, 0}, 1.5);
    EXPECT_TRUE(!edge || std::isfinite(edge->error_mm)) << x;
  }
}
