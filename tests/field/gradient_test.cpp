#include "volsurf/field/gradient.h"

#include "support/fields.h"

#include "volsurf/core/error.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr float kWall = std::numeric_limits<float>::lowest();

template <typename ValueAt> Volume volume_of(const Index3 &size, const Vec3 &spacing, ValueAt value_at)
{
  Volume volume;
  volume.grid.size = size;
  volume.grid.spacing_mm = spacing;
  for_each_sample(size, [&](const Index3 &p, SampleId) { volume.samples.push_back(static_cast<float>(value_at(p))); });
  return volume;
}

std::vector<float> planes_of(const Volume &volume, const EdgeField &field)
{
  std::vector<float> values(volume.samples.size());
  for (std::int64_t z = 0; z < volume.grid.size[2]; ++z)
    field.plane(z, values.data() + z * volume.grid.size[0] * volume.grid.size[1]);
  return values;
}

std::vector<float> field_of(const Volume &volume, const FieldOptions &options)
{
  return planes_of(volume, EdgeField(volume, options));
}

SampleId sample_at(const Volume &volume, const Index3 &p)
{
  return p[0] + volume.grid.size[0] * (p[1] + volume.grid.size[1] * p[2]);
}

/// numpy.gradient with its defaults, in float64.
double numpy_gradient(const Volume &volume, const Index3 &p, int axis)
{
  Index3 low = p;
  Index3 high = p;
  low[axis] = std::max<std::int64_t>(p[axis] - 1, 0);
  high[axis] = std::min(p[axis] + 1, volume.grid.size[axis] - 1);
  const double rise = static_cast<double>(volume.samples[sample_at(volume, high)]) -
                      static_cast<double>(volume.samples[sample_at(volume, low)]);
  return rise / (static_cast<double>(high[axis] - low[axis]) * volume.grid.spacing_mm[axis]);
}

double ulp_of(double value)
{
  const auto rounded = static_cast<float>(std::abs(value));
  return static_cast<double>(std::nextafter(rounded, std::numeric_limits<float>::infinity())) -
         static_cast<double>(rounded);
}

Volume random_volume(Dice &dice)
{
  const double scale = std::pow(10.0, static_cast<double>(dice.between(-6, 6)));
  const Vec3 spacing{0.1 * static_cast<double>(dice.between(2, 40)), 0.1 * static_cast<double>(dice.between(2, 40)),
                     0.1 * static_cast<double>(dice.between(2, 40))};
  return volume_of({dice.between(2, 9), dice.between(2, 9), dice.between(2, 9)}, spacing,
                   [&](const Index3 &) { return scale * static_cast<double>(dice.between(-30000, 30000)); });
}

/// Whether a position is as far from the border as kernels reach.
bool is_inner(const Volume &volume, const Index3 &p, double sigma_mm)
{
  for (int axis = 0; axis < 3; ++axis) {
    const auto margin = static_cast<std::int64_t>(std::ceil(4 * sigma_mm / volume.grid.spacing_mm[axis]));
    if (p[axis] < margin || p[axis] >= volume.grid.size[axis] - margin)
      return false;
  }
  return true;
}

void expect_no_negative_zero(const std::vector<float> &values)
{
  for (const float value : values)
    EXPECT_FALSE(value == 0.0F && std::signbit(value));
}

} // namespace

RC_GTEST_PROP(EdgeField, CentralDifferencesAreWithin4UlpOfNumpysInFloat64, ())
{
  Dice dice(*random_seed());
  const Volume volume = random_volume(dice);
  const auto values = field_of(volume, {0.0, false});
  for_each_sample(volume.grid.size, [&](const Index3 &p, SampleId sample) {
    const double expected =
        -std::hypot(numpy_gradient(volume, p, 0), numpy_gradient(volume, p, 1), numpy_gradient(volume, p, 2));
    RC_ASSERT(std::abs(static_cast<double>(values[sample]) - expected) <= 4 * ulp_of(expected));
  });
}

RC_GTEST_PROP(EdgeField, EdgeMapIsNegated, ())
{
  Dice dice(*random_seed());
  const Volume volume = random_volume(dice);
  const auto values = field_of(volume, {5.0, true});
  for (std::size_t i = 0; i < values.size(); ++i)
    RC_ASSERT(values[i] == -volume.samples[i]);
}

TEST(EdgeField, LinearRampHasItsSlopeForEverySigma)
{
  const Vec3 slope{3, -2, 5};
  const double expected = std::hypot(slope[0], slope[1], slope[2]);
  for (const Vec3 &spacing : {Vec3{1, 1, 1}, {0.5, 0.8, 1.5}}) {
    const Volume ramp = volume_of({60, 40, 26}, spacing, [&](const Index3 &p) {
      double value = 100;
      for (int axis = 0; axis < 3; ++axis)
        value += slope[axis] * spacing[axis] * static_cast<double>(p[axis]);
      return value;
    });
    for (const double sigma : {0.0, 0.3, 1.0, 2.0}) {
      const auto values = field_of(ramp, {sigma, false});
      int inner = 0;
      for_each_sample(ramp.grid.size, [&](const Index3 &p, SampleId sample) {
        if (!is_inner(ramp, p, sigma))
          return;
        ++inner;
        EXPECT_NEAR(values[sample], -expected, 2e-5 * expected) << "sigma " << sigma;
      });
      EXPECT_GT(inner, 0);
    }
  }
}

TEST(GaussianKernel, SumsToOneAndItsDerivativeGivesARampItsSlope)
{
  for (const double sigma : {0.2, 0.5, 1.0, 1.7, 4.0, 20.0, kLargestSigmaVoxels}) {
    const HalfKernel smooth = gaussian_kernel(sigma);
    const HalfKernel derive = gaussian_derivative_kernel(sigma);
    double sum = smooth[0];
    double slope = 0;
    for (std::size_t k = 1; k < smooth.size(); ++k) {
      sum += 2.0 * static_cast<double>(smooth[k]);
      slope += 2.0 * static_cast<double>(k) * static_cast<double>(derive[k]);
    }
    EXPECT_NEAR(sum, 1, 1e-6) << sigma;
    EXPECT_NEAR(slope, 1, 1e-6) << sigma;
    EXPECT_EQ(derive[0], 0.0F);
    EXPECT_EQ(smooth.size(), derive.size());
  }
}

TEST(EdgeField, IsNeverMinusZero)
{
  const Volume zeros = volume_of({5, 4, 3}, {1, 1, 1}, [](const Index3 &p) { return p[0] % 2 == 0 ? 0.0 : -0.0; });
  for (const FieldOptions &options : {FieldOptions{0.0, false}, {1.0, false}, {0.0, true}})
    expect_no_negative_zero(field_of(zeros, options));
}

TEST(EdgeField, OverflowIsAWallAndIsCountedOnceHoweverOftenPlanesAreMade)
{
  Volume volume = volume_of({8, 7, 9}, {1, 1, 1}, [](const Index3 &p) { return static_cast<double>(p[0]); });
  volume.samples[sample_at(volume, {3, 3, 4})] = std::numeric_limits<float>::max();
  volume.samples[sample_at(volume, {5, 3, 4})] = -std::numeric_limits<float>::max();
  for (const double sigma : {0.0, 1.0}) {
    const EdgeField field(volume, {sigma, false});
    const auto values = planes_of(volume, field);
    const auto walls = std::count(values.begin(), values.end(), kWall);
    EXPECT_GT(walls, 0) << sigma;
    EXPECT_EQ(field.non_finite_count(), walls) << sigma;
    EXPECT_EQ(planes_of(volume, field), values);
    EXPECT_EQ(field.non_finite_count(), walls) << sigma;
    for (const float value : values)
      EXPECT_TRUE(std::isfinite(value));
  }
}

RC_GTEST_PROP(EdgeField, ShiftedVolumeHasTheShiftedField, ())
{
  Dice dice(*random_seed());
  const double sigma = 0.5 * static_cast<double>(dice.between(0, 2));
  const Index3 size{14, 13, 12};
  std::vector<std::int64_t> noise;
  for_each_sample({20, 20, 20}, [&](const Index3 &, SampleId) { noise.push_back(dice.between(0, 4000)); });
  const Index3 shift{dice.between(0, 3), dice.between(0, 3), dice.between(0, 3)};
  const auto cut_at = [&](const Index3 &begin) {
    return volume_of(size, {1, 1, 1}, [&](const Index3 &p) {
      return static_cast<double>(
          noise[static_cast<std::size_t>(p[0] + begin[0] + 20 * (p[1] + begin[1] + 20 * (p[2] + begin[2])))]);
    });
  };
  const Volume volume = cut_at({0, 0, 0});
  const Volume shifted = cut_at(shift);
  const auto values = field_of(volume, {sigma, false});
  const auto shifted_values = field_of(shifted, {sigma, false});
  for_each_sample(size, [&](const Index3 &p, SampleId sample) {
    const Index3 q{p[0] + shift[0], p[1] + shift[1], p[2] + shift[2]};
    if (is_inner(shifted, p, std::max(sigma, 0.25)) && is_inner(volume, q, std::max(sigma, 0.25)))
      RC_ASSERT(shifted_values[sample] == values[sample_at(volume, q)]);
  });
}

TEST(EdgeField, GradientMagnitudeIsTheFieldNegated)
{
  Dice dice(3);
  const Volume volume = random_volume(dice);
  const EdgeField field(volume, {1.0, false});
  const Volume magnitude = gradient_magnitude(field, volume.grid);
  const auto values = planes_of(volume, field);
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_EQ(magnitude.samples[i], -values[i]);
}

TEST(EdgeField, SigmaIsTheMeanSpacingWithinTheLimitUnlessSaid)
{
  const auto sigma_mm = [](const Vec3 &spacing_mm) {
    const Volume volume = volume_of({4, 4, 4}, spacing_mm, [](const Index3 &) { return 0.0; });
    return EdgeField(volume, {}).sigma_mm();
  };
  EXPECT_DOUBLE_EQ(sigma_mm({2, 0.25, 2}), 1);
  EXPECT_DOUBLE_EQ(sigma_mm({10, 0.001, 10}), 0.001 * kLargestSigmaVoxels);
}

TEST(EdgeField, RefusesASigmaThatIsNegativeHugeOrNotANumber)
{
  const Volume volume = volume_of({4, 4, 4}, {1, 1, 1}, [](const Index3 &) { return 0.0; });
  for (const double sigma : {-1.0, 1000.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(EdgeField(volume, {sigma, false}), UsageError) << sigma;
}
