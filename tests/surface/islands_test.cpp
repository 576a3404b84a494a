#include "volsurf/surface/islands.h"

#include "support/label_volumes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr RegionId kBackground = 1;

/// Spreads the smallest region id of each cell to its neighbours until nothing changes.
std::vector<RegionId> naive_islands(const LabelledCells &labels)
{
  const Index3 &n = labels.cells.size;
  std::vector<RegionId> island(labels.region_of_basin.size() + 1);
  for (const RegionId region : labels.region_of_basin)
    island[region] = region == kBackground ? kNoRegion : region;
  for (bool changed = true; changed;) {
    changed = false;
    for_each_sample(n, [&](const Index3 &p, CellId) {
      for (int axis = 0; axis < 3; ++axis) {
        Index3 q = p;
        if (++q[axis] == n[axis])
          continue;
        RegionId &a = island[labels.region_of_basin[labels.at(p)]];
        RegionId &b = island[labels.region_of_basin[labels.at(q)]];
        if (a != b && a != kNoRegion && b != kNoRegion) {
          a = b = std::min(a, b);
          changed = true;
        }
      }
    });
  }
  return island;
}

} // namespace

RC_GTEST_PROP(FindIslands, AreWhatFacesOfCellsConnect, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 6, 12);
  const std::size_t regions = labels.region_of_basin.size();
  RC_ASSERT(find_islands(labels.cells, labels.region_of_basin, regions, kBackground) == naive_islands(labels));
}

TEST(FindIslands, CellsThatTouchAlongAnEdgeOnlyAreTwoIslands)
{
  const LabelledCells labels = label_cells({2, 2, 1}, 3, [](const Index3 &p) {
    return p[0] != p[1] ? 0U : p[0] == 0 ? 1U : 2U;
  });
  EXPECT_EQ(find_islands(labels.cells, labels.region_of_basin, 3, kBackground), (std::vector<RegionId>{0, 0, 2, 3}));
}
