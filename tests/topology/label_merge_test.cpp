#include "volsurf/topology/label_merge.h"

#include "support/fields.h"

#include "volsurf/topology/background.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

using namespace volsurf;
using namespace volsurf::support;

namespace {

/// Labels from `lowest` on, some of which do not occur.
LabelVolume random_labels(Dice &dice, std::uint32_t lowest)
{
  LabelVolume labels;
  labels.grid.size = {dice.between(2, 6), dice.between(2, 6), dice.between(2, 6)};
  const std::int64_t step = dice.between(1, 9);
  const std::int64_t count = dice.between(1, 8);
  for_each_sample(labels.grid.size, [&](const Index3 &, SampleId) {
    labels.labels.push_back(lowest + static_cast<std::uint32_t>(step * dice.between(0, count - 1)));
  });
  return labels;
}

std::map<std::uint32_t, std::int64_t> counts_of(const std::vector<std::uint32_t> &labels)
{
  std::map<std::uint32_t, std::int64_t> counts;
  for (const std::uint32_t label : labels)
    ++counts[label];
  return counts;
}

} // namespace

RC_GTEST_PROP(LabelMerge, HasTheLabelsAsRegionsAtEveryDelta, (double delta))
{
  RC_PRE(delta > 0);
  Dice dice(*random_seed());
  const LabelVolume labels = random_labels(dice, 0);
  const RegionMerge merge = merge_of_labels(labels);
  const Regions regions = cut(merge.hierarchy, delta);
  const auto counts = counts_of(labels.labels);
  RC_ASSERT(merge.cells.size == labels.grid.size);
  RC_ASSERT(regions.count() == counts.size());
  std::map<std::uint32_t, RegionId> region_of_label;
  for (std::size_t i = 0; i < labels.labels.size(); ++i) {
    const RegionId region = regions.of_basin[merge.cells.basins[static_cast<std::int64_t>(i)]];
    const auto [known, is_new] = region_of_label.emplace(labels.labels[i], region);
    RC_ASSERT(known->second == region);
    RC_ASSERT(regions.cell_counts[region - 1] == counts.at(labels.labels[i]));
    if (is_new)
      RC_ASSERT(merge.hierarchy.roots[regions.maxima[region - 1]] == static_cast<CellId>(i));
  }
}

RC_GTEST_PROP(LabelMerge, HasLabel0AsItsBackgroundAndElseTheOneMostAtTheBorder, ())
{
  Dice dice(*random_seed());
  const LabelVolume labels = random_labels(dice, static_cast<std::uint32_t>(dice.between(0, 2)));
  const RegionMerge merge = merge_of_labels(labels);
  const CellId root = merge.hierarchy.roots[merge.hierarchy.background];
  if (counts_of(labels.labels).count(0) > 0) {
    RC_ASSERT(labels.labels[static_cast<std::size_t>(root)] == 0U);
    return;
  }
  const auto faces = count_border_faces(merge.cells, merge.hierarchy.basin_count());
  RC_ASSERT(faces[merge.hierarchy.background] == *std::max_element(faces.begin(), faces.end()));
}

RC_GTEST_PROP(LabelMerge, HasWallsThatNoDeltaTakesAway, ())
{
  Dice dice(*random_seed());
  const RegionMerge merge = merge_of_labels(random_labels(dice, 1));
  const auto last = static_cast<BasinId>(merge.hierarchy.basin_count() - 1);
  RC_PRE(last > 0);
  RC_ASSERT(saliency(merge.hierarchy, 0, last) == std::numeric_limits<float>::infinity());
  RC_ASSERT(saliency(merge.hierarchy, last, last / 2) == std::numeric_limits<float>::infinity());
}
