#include "volsurf/field/smooth_volume.h"

#include "support/fields.h"

#include "volsurf/field/gradient.h"

#include <gtest/gtest.h>

#include <functional>

using namespace volsurf;
using namespace volsurf::support;

namespace {

const Vec3 kSpacing{0.8, 1.0, 1.3};

Volume volume_of(const std::function<double(const Vec3 &)> &value_at_mm)
{
  Volume volume;
  volume.grid.size = {24, 22, 20};
  volume.grid.spacing_mm = kSpacing;
  for_each_sample(volume.grid.size, [&](const Index3 &p, SampleId) {
    volume.samples.push_back(static_cast<float>(
        value_at_mm({static_cast<double>(p[0]) * kSpacing[0], static_cast<double>(p[1]) * kSpacing[1],
                     static_cast<double>(p[2]) * kSpacing[2]})));
  });
  return volume;
}

/// Waves of several millimetres.
double waves(const Vec3 &p)
{
  return 100 * std::sin(0.5 * p[0]) * std::cos(0.4 * p[1]) + 60 * std::sin(0.45 * p[2] + 0.3 * p[0]);
}

Vec3 index_of(double x_mm, double y_mm, double z_mm)
{
  return {x_mm / kSpacing[0], y_mm / kSpacing[1], z_mm / kSpacing[2]};
}

} // namespace

TEST(SmoothVolume, KnowsTheDerivativesOfAQuadraticExactly)
{
  const Volume volume = volume_of([](const Vec3 &p) {
    return 3 * p[0] - 2 * p[1] + p[2] + 0.5 * p[0] * p[0] - p[1] * p[1] + 1.5 * p[2] * p[2] + p[0] * p[1] -
           2 * p[0] * p[2] + 0.25 * p[1] * p[2];
  });
  for (const double sigma : {0.0, 1.0, 1.5}) {
    const SmoothVolume smooth(volume, sigma);
    const double x = 9.13;
    const double y = 10.71;
    const double z = 12.4;
    const Derivatives d = smooth.derivatives_at(index_of(x, y, z));
    EXPECT_NEAR(d.gradient[0], 3 + x + y - 2 * z, 0.01) << sigma;
    EXPECT_NEAR(d.gradient[1], -2 - 2 * y + x + 0.25 * z, 0.01) << sigma;
    EXPECT_NEAR(d.gradient[2], 1 + 3 * z - 2 * x + 0.25 * y, 0.01) << sigma;
    EXPECT_NEAR(d.second[0], 1, 0.01) << sigma;
    EXPECT_NEAR(d.second[1], -2, 0.01) << sigma;
    EXPECT_NEAR(d.second[2], 3, 0.01) << sigma;
    EXPECT_NEAR(d.second_mixed[0], 0.25, 0.01) << sigma;
    EXPECT_NEAR(d.second_mixed[1], -2, 0.01) << sigma;
    EXPECT_NEAR(d.second_mixed[2], 1, 0.01) << sigma;
  }
}

TEST(SmoothVolume, SecondDerivativesAreThoseOfTheGradient)
{
  const SmoothVolume smooth(volume_of(waves), 1.0);
  constexpr double kStep = 1e-4;
  for (const Vec3 &place : {Vec3{10, 11, 12}, Vec3{8.3, 9.9, 14.2}, Vec3{15.02, 6.5, 5.77}}) {
    const Derivatives d = smooth.derivatives_at(place);
    const std::array<Vec3, 3> hessian{Vec3{d.second[0], d.second_mixed[2], d.second_mixed[1]},
                                      Vec3{d.second_mixed[2], d.second[1], d.second_mixed[0]},
                                      Vec3{d.second_mixed[1], d.second_mixed[0], d.second[2]}};
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 low = place;
      Vec3 high = place;
      low[axis] -= kStep;
      high[axis] += kStep;
      const Vec3 before = smooth.derivatives_at(low).gradient;
      const Vec3 after = smooth.derivatives_at(high).gradient;
      for (int component = 0; component < 3; ++component)
        EXPECT_NEAR((after[component] - before[component]) / (2 * kStep * kSpacing[axis]), hessian[axis][component],
                    0.01);
    }
  }
}

TEST(SmoothVolume, ItsGradientIsTheFieldsAtTheSamples)
{
  const Volume volume = volume_of(waves);
  const double sigma = 1.5;
  const SmoothVolume smooth(volume, sigma);
  const Volume magnitude = gradient_magnitude(EdgeField(volume, {sigma, false}), volume.grid);
  for (const Index3 &p : {Index3{10, 11, 9}, Index3{7, 14, 12}, Index3{13, 8, 10}}) {
    const Vec3 g =
        smooth.derivatives_at({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])})
            .gradient;
    const auto expected = static_cast<double>(
        magnitude.samples[static_cast<std::size_t>(p[0] + volume.grid.size[0] * (p[1] + volume.grid.size[1] * p[2]))]);
    EXPECT_NEAR(std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]), expected, 0.02 * expected);
  }
}

TEST(SmoothVolume, ContinuesBeyondTheBorder)
{
  const SmoothVolume smooth(volume_of([](const Vec3 &p) { return 5 * p[0]; }), 1.0);
  EXPECT_EQ(smooth.derivatives_at({-3, 5, 5}).gradient, smooth.derivatives_at({0, 5, 5}).gradient);
  EXPECT_EQ(smooth.derivatives_at({30, 5, 5}).gradient, smooth.derivatives_at({23, 5, 5}).gradient);
}
