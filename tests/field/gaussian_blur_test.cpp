#include "volsurf/field/gaussian_blur.h"

#include "volsurf/core/error.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace volsurf;

namespace {

Volume impulse()
{
  Volume volume;
  volume.grid.size = {31, 29, 33};
  volume.grid.spacing_mm = {0.8, 1, 1.3};
  volume.samples.assign(static_cast<std::size_t>(volume.grid.sample_count()), 0.0F);
  volume.samples[static_cast<std::size_t>((16 * 29 + 14) * 31 + 15)] = 1;
  return volume;
}

} // namespace

TEST(GaussianBlur, SpreadsAnImpulseByTheVarianceInMillimetresAndKeepsItsSum)
{
  const Volume volume = impulse();
  const std::vector<float> blurred = gaussian_blur(volume, 1.5);
  double sum = 0;
  Vec3 variance{};
  for (std::int64_t i = 0; i < volume.grid.sample_count(); ++i) {
    const double weight = blurred[static_cast<std::size_t>(i)];
    const Vec3 offset{static_cast<double>(i % 31 - 15) * 0.8, static_cast<double>(i / 31 % 29 - 14),
                      static_cast<double>(i / (31 * 29) - 16) * 1.3};
    sum += weight;
    for (int axis = 0; axis < 3; ++axis)
      variance[axis] += weight * offset[axis] * offset[axis];
  }
  EXPECT_NEAR(sum, 1, 1e-5);
  for (const double along_axis : variance)
    EXPECT_NEAR(along_axis, 1.5 * 1.5, 0.01);
}

TEST(GaussianBlur, LeavesTheSamplesAsTheyAreAtZeroAndRefusesWhatNoKernelHas)
{
  const Volume volume = impulse();
  EXPECT_EQ(gaussian_blur(volume, 0), volume.samples);
  EXPECT_THROW(gaussian_blur(volume, -1), UsageError);
  EXPECT_THROW(gaussian_blur(volume, std::nan("")), UsageError);
  EXPECT_THROW(gaussian_blur(volume, 1000), UsageError);
}
