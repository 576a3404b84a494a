// How well a surface agrees with a known truth, at every delta at once.
//
// In: the merge of a scan, and which of its cells are true. Out: the Dice coefficient, a step function of delta. A
// basin leaves the region of a given basin as delta decreases, at the saliency between the two (docs/method.md T6), and
// never comes back. So the basins are taken in the order in which they leave, once: no cut and no flood fill for each
// delta.
#pragma once

#include "volsurf/topology/region_merge.h"

#include <vector>

namespace volsurf::bench {

/// For each cell of CellLabels: 1 where it is true, else 0.
using CellMask = std::vector<std::uint8_t>;

/// From the next step's delta, which is not part of it, up to and with its own.
struct DiceStep {
  double delta; ///< decreasing from step to step, the first is infinite
  double dice;  ///< 2 |A and B| / (|A| + |B|), 0 .. 1
};

using DiceCurve = std::vector<DiceStep>;

/// A: of what is not background, the largest part that is connected over faces; about what `--surface hull --keep 1`
/// encloses. Steps end at delta >= `lowest`. O(n log n) for n faces between basins, 12 bytes for each of these.
DiceCurve hull_dice(const RegionMerge &merge, const CellMask &truth, double lowest);

/// A: the region of a basin, what `--seed` asks for. O(basins * ancestors).
DiceCurve region_dice(const RegionMerge &merge, const CellMask &truth, BasinId seed, double lowest);

/// delta > 0; the last step's where delta is below it. O(log steps).
double dice_at(const DiceCurve &curve, double delta);

} // namespace volsurf::bench
