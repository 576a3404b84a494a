#include "volsurf/baseline/watershed.h"

#include "support/fields.h"
#include "support/merge_of_field.h"

#include "volsurf/core/parallel.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

/// The edge strength -I.
Volume strength_of(const Field &field)
{
  Volume volume;
  volume.grid.size = field.size;
  for (const float value : field.values)
    volume.samples.push_back(-value);
  return volume;
}

/// Levels between two persistences that follow each other, and below the first: ITK joins at a level what volsurf still
/// keeps apart at that delta.
std::vector<float> levels_between(const std::multiset<float> &persistences)
{
  const std::set<float> distinct(persistences.begin(), persistences.end());
  std::vector<float> levels;
  float below = 0;
  for (const float persistence : distinct) {
    levels.push_back((below + persistence) / 2);
    below = persistence;
  }
  levels.push_back(below + 1);
  return levels;
}

} // namespace

RC_GTEST_PROP(MorphologicalWatershed, HasAsManyRegionsAsTheMergeAtTheSameDelta, ())
{
  Field field = *random_field();
  for (float &value : field.values)
    value = std::round(64 * value) / 64; // so that persistences and the levels between them are exact
  const RegionMerge merge = merge_of(field, Exterior::none);
  for (const float level : levels_between(positive_persistences(merge.hierarchy))) {
    const LabelVolume labels = morphological_watershed(strength_of(field), level);
    const std::set<std::uint32_t> distinct(labels.labels.begin(), labels.labels.end());
    RC_ASSERT(distinct.size() == cut(merge.hierarchy, level).count());
    RC_ASSERT(*distinct.begin() == 1U);
    RC_ASSERT(*distinct.rbegin() == distinct.size());
  }
}

TEST(MorphologicalWatershed, IsTheSameForAnyNumberOfThreads)
{
  const Volume volume = strength_of(make_field(11, 20));
  const LabelVolume first = morphological_watershed(volume, 2);
  for (const int threads : {1, 2, 5}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(morphological_watershed(volume, 2).labels, first.labels);
  }
}

TEST(MorphologicalWatershed, StopsWhenAskedTo)
{
  EXPECT_THROW(
      morphological_watershed(strength_of(make_field(11, 20)), 2, [](std::string_view, double) { return false; }),
      Cancelled);
}
