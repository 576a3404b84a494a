#include "volsurf/surface/cell_box.h"

#include "support/grids.h"
#include "support/label_volumes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

Sides only(const LabelledCells &labels, RegionId region)
{
  Sides sides{labels.region_of_basin, 0};
  for (RegionId &side : sides.of_basin)
    side = side == region ? region : 0;
  return sides;
}

} // namespace

RC_GTEST_PROP(CellBox, HoldsTheRegionAndOneCellAround, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 20, 5);
  const Index3 &n = labels.cells.size;
  const std::vector<RegionId> &wanted = labels.region_of_basin;
  const auto boxes = boxes_around(labels.cells, labels.region_of_basin, wanted);
  RC_ASSERT(boxes.size() == wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    Index3 low = n;
    Index3 high{0, 0, 0};
    for_each_sample(n, [&](const Index3 &p, CellId) {
      for (int axis = 0; axis < 3 && labels.at(p) == i; ++axis) {
        low[axis] = std::min(low[axis], std::max<std::int64_t>(p[axis] - 1, 0));
        high[axis] = std::max(high[axis], std::min(p[axis] + 2, n[axis]));
      }
    });
    if (high[0] > 0) {
      RC_ASSERT(boxes[i].low == low);
      RC_ASSERT(boxes[i].high == high);
    } else {
      RC_ASSERT(boxes[i].size() == (Index3{0, 0, 0}));
    }
  }
}

// So a region's surface may be made in its box. Positions are small multiples of powers of two, which no order of
// summing rounds.
RC_GTEST_PROP(CellBox, TheSurfaceOfARegionInItsBoxIsTheOneInTheVolume, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 7, 4);
  const RegionId region = labels.region_of_basin[static_cast<std::size_t>(
      dice.between(0, static_cast<std::int64_t>(labels.region_of_basin.size()) - 1))];
  const CellBox box = boxes_around(labels.cells, labels.region_of_basin, {region}).front();
  RC_PRE(box.size()[0] > 0);
  Grid grid = grid_of(labels.cells.size);
  grid.spacing_mm = {0.5, 2, 1};
  grid.origin_mm = {-3, 8, 0.25};
  const Sides sides = only(labels, region);
  const Mesh whole = mesh_of(labels, grid, sides, true);
  const LabelledCells cropped{cells_in(box, labels.cells), labels.region_of_basin};
  const Mesh part = mesh_of(cropped, grid_in(box, grid), sides, true);
  RC_ASSERT(part.points == whole.points);
  RC_ASSERT(part.triangles == whole.triangles);
  RC_ASSERT(part.region_a == whole.region_a);
  RC_ASSERT(part.region_b == whole.region_b);
  RC_ASSERT(part.persistence == whole.persistence);
  RC_ASSERT(part.component == whole.component);
  RC_ASSERT(part.cap == whole.cap);
}
