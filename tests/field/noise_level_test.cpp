#include "volsurf/field/noise_level.h"

#include "volsurf/core/parallel.h"
#include "volsurf/field/oversample.h"
#include "volsurf/phantom/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace volsurf;

namespace {

constexpr double kDeviation = 7;

/// Gaussian noise over what value_at(x, y, z) gives.
template <typename ValueAt> Volume noisy_volume(const Index3 &size, const Vec3 &spacing_mm, ValueAt value_at)
{
  Volume volume;
  volume.grid.size = size;
  volume.grid.spacing_mm = spacing_mm;
  volume.samples.resize(static_cast<std::size_t>(volume.grid.sample_count()));
  NoiseOptions noise{NoiseKind::kGaussian, kDeviation, 3};
  add_noise(volume, noise);
  std::size_t i = 0;
  for (std::int64_t z = 0; z < size[2]; ++z)
    for (std::int64_t y = 0; y < size[1]; ++y)
      for (std::int64_t x = 0; x < size[0]; ++x, ++i)
        volume.samples[i] = static_cast<float>(value_at(x, y, z, static_cast<double>(volume.samples[i])));
  return volume;
}

Volume pure_noise(const Index3 &size, const Vec3 &spacing_mm)
{
  return noisy_volume(size, spacing_mm, [](auto, auto, auto, double noise) { return noise; });
}

double noise_of(const Volume &volume)
{
  return measure_noise(volume, EdgeField(volume, {})).volume;
}

/// The root mean square of |grad g| away from the border.
double rms_gradient(const Volume &volume, const EdgeField &field, std::int64_t margin)
{
  const Volume magnitude = gradient_magnitude(field, volume.grid);
  const auto &[nx, ny, nz] = volume.grid.size;
  double sum = 0;
  std::int64_t count = 0;
  for (std::int64_t z = margin; z < nz - margin; ++z)
    for (std::int64_t y = margin; y < ny - margin; ++y)
      for (std::int64_t x = margin; x < nx - margin; ++x, ++count)
        sum += std::pow(static_cast<double>(magnitude.samples[static_cast<std::size_t>(x + nx * (y + ny * z))]), 2);
  return std::sqrt(sum / static_cast<double>(count));
}

} // namespace

TEST(MeasureNoise, FindsTheDeviationOfWhiteNoise)
{
  EXPECT_NEAR(noise_of(pure_noise({64, 64, 64}, {1, 1, 1})), kDeviation, 0.02 * kDeviation);
  EXPECT_NEAR(noise_of(pure_noise({200, 180, 160}, {1, 1, 1})), kDeviation, 0.02 * kDeviation) << "rows are left out";
}

TEST(MeasureNoise, DoesNotSeeWhatChangesEvenlyNorAMinorityOfEdges)
{
  const Volume volume = noisy_volume({64, 64, 64}, {1, 1, 1}, [](auto x, auto y, auto z, double noise) {
    const double organ = x > 20 && x < 40 && y > 20 && y < 40 && z > 25 ? 500 : 0;
    return organ + 3.0 * static_cast<double>(x) - 2.0 * static_cast<double>(y * z) / 10 + noise;
  });
  EXPECT_NEAR(noise_of(volume), kDeviation, 0.03 * kDeviation);
}

TEST(MeasureNoise, LeavesOutMaskedBackground)
{
  const Volume volume =
      noisy_volume({64, 64, 64}, {1, 1, 1}, [](auto x, auto, auto, double noise) { return x < 44 ? 0 : noise; });
  EXPECT_NEAR(noise_of(volume), kDeviation, 0.05 * kDeviation);
}

TEST(MeasureNoise, IsNothingInAConstantVolume)
{
  Volume volume = pure_noise({8, 8, 8}, {1, 1, 1});
  std::fill(volume.samples.begin(), volume.samples.end(), 5.0F);
  EXPECT_EQ(noise_of(volume), 0);
}

TEST(MeasureNoise, TakesVolumesOfTwoSamplesAlongAnAxis)
{
  EXPECT_NEAR(noise_of(pure_noise({2, 200, 200}, {1, 1, 1})), kDeviation, 0.05 * kDeviation);
  EXPECT_NEAR(noise_of(pure_noise({200, 2, 200}, {1, 1, 1})), kDeviation, 0.05 * kDeviation);
  EXPECT_NEAR(noise_of(pure_noise({200, 200, 2}, {1, 1, 1})), kDeviation, 0.05 * kDeviation);
}

TEST(MeasureNoise, IsTheSameForAnyNumberOfThreads)
{
  const Volume volume = pure_noise({70, 50, 90}, {1, 1, 1});
  const double expected = noise_of(volume);
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(noise_of(volume), expected);
  }
}

TEST(NoiseGain, IsTheDeviationThatTheGradientOfNoiseHas)
{
  const Vec3 spacing_mm{0.8, 0.8, 0.8};
  const Volume volume = pure_noise({72, 72, 72}, spacing_mm);
  for (const double sigma_mm : {0.0, 0.8, 1.6}) {
    const EdgeField field(volume, {sigma_mm, false});
    const double expected = std::sqrt(3.0) * kDeviation * field.noise_gain(); // three components
    EXPECT_NEAR(rms_gradient(volume, field, 10), expected, 0.03 * expected) << sigma_mm;
  }
}

TEST(NoiseGain, IsThatOfTheAxisWhereNoiseIsStrongest)
{
  const Volume volume = pure_noise({64, 64, 64}, {0.5, 4, 4}); // along y and z there is next to nothing
  const EdgeField field(volume, {0.0, false});
  const double expected = kDeviation * field.noise_gain();
  EXPECT_NEAR(rms_gradient(volume, field, 2), expected, 0.03 * expected);
}

TEST(NoiseGain, IsOneForAnEdgeMap)
{
  const Volume volume = pure_noise({8, 8, 8}, {0.5, 0.5, 0.5});
  EXPECT_EQ(EdgeField(volume, {std::nullopt, true}).noise_gain(), 1);
}

TEST(MeasureNoise, OfAFinerGridIsThatOfTheScan)
{
  const Volume scan = pure_noise({40, 50, 60}, {1, 2, 3});
  Volume fine = scan;
  oversample(fine, 2);
  EXPECT_EQ(noise_of(fine), noise_of(scan));
}

TEST(NoiseGain, OnAFinerGridIsThatOfTheScansNoise)
{
  const Volume scan = pure_noise({48, 48, 48}, {1, 1, 1});
  Volume fine = scan;
  oversample(fine, 2);
  for (const double sigma_mm : {0.75, 1.0, 2.0}) {
    const EdgeField field(fine, {sigma_mm, false});
    const double expected = std::sqrt(3.0) * kDeviation * field.noise_gain();
    EXPECT_NEAR(rms_gradient(fine, field, 20), expected, 0.12 * expected) << sigma_mm;
    EXPECT_NEAR(field.noise_gain(), EdgeField(scan, {sigma_mm, false}).noise_gain(), 0.05 * field.noise_gain());
  }
}
