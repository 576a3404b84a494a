#include "volsurf/field/median.h"

#include "support/fields.h"
#include "support/volume_of_field.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

Volume filtered(Volume volume, int radius)
{
  filter_by_median(volume, radius);
  return volume;
}

/// The samples around one, those beyond the border being the border's, sorted: the one in the middle.
float naive_median(const Volume &volume, const Index3 &p, int radius)
{
  const Index3 &n = volume.grid.size;
  const std::int64_t width = 2 * radius + 1;
  std::vector<float> around;
  for_each_sample({width, width, width}, [&](const Index3 &step, SampleId) {
    Index3 q{};
    for (int axis = 0; axis < 3; ++axis)
      q[axis] = std::clamp<std::int64_t>(p[axis] + step[axis] - radius, 0, n[axis] - 1);
    around.push_back(volume.samples[q[0] + n[0] * (q[1] + n[1] * q[2])]);
  });
  std::sort(around.begin(), around.end());
  return around[around.size() / 2];
}

/// Dark for x below 4, bright from there on.
Volume wall()
{
  Volume volume;
  volume.grid.size = {9, 8, 7};
  for_each_sample(volume.grid.size, [&](const Index3 &p, SampleId) { volume.samples.push_back(p[0] < 4 ? 10 : 90); });
  return volume;
}

} // namespace

RC_GTEST_PROP(Median, IsTheMiddleOfTheSortedSamplesAround, ())
{
  const Volume volume = volume_of(*random_field());
  const int radius = *rc::gen::element(1, 1, 2, 3);
  const ThreadLimit limit(*rc::gen::element(1, 2, 5));
  const Volume result = filtered(volume, radius);
  for_each_sample(volume.grid.size, [&](const Index3 &p, SampleId sample) {
    RC_ASSERT(result.samples[sample] == naive_median(volume, p, radius));
  });
}

TEST(Median, OfRadius0IsTheVolumeItself)
{
  const Volume volume = volume_of(make_field(3, 6));
  EXPECT_EQ(filtered(volume, 0).samples, volume.samples);
}

TEST(Median, TakesOutImpulsesAndLeavesAStraightWall)
{
  const Volume clean = wall();
  Volume volume = clean;
  for (const SampleId impulse : {0, 13, 200, 203, 251, 503})
    volume.samples[impulse] = 1e6;
  EXPECT_EQ(filtered(volume, 1).samples, clean.samples);
}

TEST(Median, RefusesARadiusOutOfRange)
{
  for (const int radius : {-1, 4})
    EXPECT_THROW(filtered(wall(), radius), UsageError) << radius;
}

TEST(Median, StopsWhenAskedTo)
{
  Volume volume = volume_of(make_field(3, 6));
  int calls = 0;
  EXPECT_THROW(filter_by_median(volume, 1, [&](std::string_view, double) { return ++calls < 2; }), Cancelled);
}
