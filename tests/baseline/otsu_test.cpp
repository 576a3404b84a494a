#include "volsurf/baseline/otsu.h"

#include "support/fields.h"

#include "volsurf/core/parallel.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

/// Samples around `low` and, `bright` of 100, around `high`, each spread over 0 .. spread.
Volume two_peaks(Dice &dice, std::int64_t low, std::int64_t high, std::int64_t spread, std::int64_t bright)
{
  Volume volume;
  volume.grid.size = {12, 13, 14};
  for_each_sample(volume.grid.size, [&](const Index3 &, SampleId) {
    volume.samples.push_back(
        static_cast<float>((dice.between(1, 100) <= bright ? high : low) + dice.between(0, spread)));
  });
  return volume;
}

} // namespace

RC_GTEST_PROP(Otsu, SeparatesTwoPeaksAndIsTheSameForAnyNumberOfThreads, ())
{
  Dice dice(*random_seed());
  const std::int64_t low = dice.between(-2000, 2000);
  const std::int64_t spread = dice.between(0, 50);
  const std::int64_t high = low + 4 * spread + dice.between(20, 500);
  const Volume volume = two_peaks(dice, low, high, spread, dice.between(20, 80));
  const double iso = otsu_value(volume);
  // Bins have a width: the border lies in the gap or at most one bin off its ends.
  const double bin = static_cast<double>(high + spread - low) / 256;
  RC_ASSERT(iso > static_cast<double>(low + spread) - bin);
  RC_ASSERT(iso < static_cast<double>(high) + bin);
  const ThreadLimit limit(*rc::gen::element(1, 2, 5));
  RC_ASSERT(otsu_value(volume) == iso);
}

TEST(Otsu, OfOneValueIsThatValue)
{
  Volume volume;
  volume.grid.size = {2, 3, 4};
  volume.samples.assign(24, 7.5F);
  EXPECT_EQ(otsu_value(volume), 7.5);
}
