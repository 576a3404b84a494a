#include "volsurf/field/oversample.h"

#include "support/fields.h"
#include "support/volume_of_field.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

using namespace volsurf;
using namespace volsurf::support;

namespace {

Volume oversampled(Volume volume, int factor = 2)
{
  oversample(volume, factor);
  return volume;
}

float at(const Volume &volume, const Index3 &p)
{
  const Index3 &n = volume.grid.size;
  return volume.samples[p[0] + n[0] * (p[1] + n[1] * p[2])];
}

/// With the axes x and z exchanged.
Volume turned(const Volume &volume)
{
  Volume result;
  const Index3 &n = volume.grid.size;
  result.grid.size = {n[2], n[1], n[0]};
  for_each_sample(result.grid.size, [&](const Index3 &p, SampleId) {
    result.samples.push_back(at(volume, {p[2], p[1], p[0]}));
  });
  return result;
}

/// A polynomial of third degree in each of the world's axes.
double cubic(const Vec3 &p)
{
  const auto along = [](double t) { return 1 + t * (0.5 - t * (0.25 - 0.125 * t)); };
  return along(p[0]) * along(p[1] / 2) * along(p[2] / 3);
}

Volume cubic_volume()
{
  Volume volume;
  volume.grid = {{8, 7, 6}, {1, 2, 3}, {-3, 4, 2}};
  for_each_sample(volume.grid.size, [&](const Index3 &p, SampleId) {
    volume.samples.push_back(
        static_cast<float>(cubic(index_to_world(volume.grid, {double(p[0]), double(p[1]), double(p[2])}))));
  });
  return volume;
}

} // namespace

RC_GTEST_PROP(Oversample, KeepsTheScansSamplesInTheirPlaces, ())
{
  const Volume scan = volume_of(*random_field());
  const ThreadLimit limit(*rc::gen::element(1, 2, 5));
  const Volume fine = oversampled(scan);
  for_each_sample(scan.grid.size, [&](const Index3 &p, SampleId sample) {
    RC_ASSERT(at(fine, {2 * p[0], 2 * p[1], 2 * p[2]}) == scan.samples[sample]);
  });
}

RC_GTEST_PROP(Oversample, TakesAllAxesAlike, ())
{
  Volume scan = volume_of(*random_field());
  for (float &sample : scan.samples)
    sample = std::round(std::clamp(sample, -100.0F, 100.0F)); // so that no sum is rounded
  RC_ASSERT(turned(oversampled(scan)).samples == oversampled(turned(scan)).samples);
}

TEST(Oversample, IsExactForCubicsAwayFromTheBorder)
{
  const Volume fine = oversampled(cubic_volume());
  const Index3 &n = fine.grid.size;
  for_each_sample(n, [&](const Index3 &p, SampleId sample) {
    for (int axis = 0; axis < 3; ++axis)
      if (p[axis] < 2 || p[axis] > n[axis] - 3)
        return;
    const double expected = cubic(index_to_world(fine.grid, {double(p[0]), double(p[1]), double(p[2])}));
    EXPECT_NEAR(fine.samples[sample], expected, 1e-5 * std::abs(expected));
  });
}

TEST(Oversample, LeavesNoTraceInAFlatVolume)
{
  Volume flat;
  flat.grid.size = {2, 3, 4};
  flat.samples.assign(24, 7.0F);
  EXPECT_EQ(oversampled(flat).samples, std::vector<float>(3 * 5 * 7, 7.0F));
}

TEST(Oversample, GridsLeadToEachOther)
{
  const Grid scan = cubic_volume().grid;
  const Grid fine = oversampled_grid(scan, 2);
  EXPECT_EQ(fine.size, (Index3{15, 13, 11}));
  EXPECT_EQ(fine.oversampling, 2);
  EXPECT_EQ(index_to_world(fine, {4, 6, 8}), index_to_world(scan, {2, 3, 4}));
  const Grid back = scan_grid(fine);
  EXPECT_EQ(back.size, scan.size);
  EXPECT_EQ(back.spacing_mm, scan.spacing_mm);
  EXPECT_EQ(back.oversampling, 1);
}

TEST(Oversample, By1IsTheVolumeItselfAndByMoreThan2IsRefused)
{
  const Volume scan = cubic_volume();
  EXPECT_EQ(oversampled(scan, 1).samples, scan.samples);
  for (const int factor : {0, 3})
    EXPECT_THROW(oversampled(scan, factor), UsageError) << factor;
}
