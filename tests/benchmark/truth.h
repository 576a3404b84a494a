// What is known to be right of a scan: samples that count, named by a rule on the values of a volume.
#pragma once

#include "benchmark/dice_curve.h"

#include "volsurf/core/volume.h"

#include <string>
#include <vector>

namespace volsurf::bench {

enum class TruthKind {
  kValues,  ///< "values:4,5,6": samples with one of these values
  kFrom,    ///< "from:1": samples of this value or more
  kFilled,  ///< "filled:30": in each slice, all but what is connected to its rim through samples of less
  kLargest, ///< "largest:97": of samples of this value or more, the largest connected part
};

/// Connected is over the faces of voxels: 6 neighbours, within a slice 4. A slice is across the last axis: axial in
/// most scans. Holes are filled slice by slice, because a head that the lower end of the scan cuts open has none
/// otherwise.
struct TruthRule {
  TruthKind kind;
  std::vector<double> values; ///< one but for kValues
};

/// Throws UsageError.
TruthRule parse_truth(const std::string &text);

/// A cell is true where 4 or more of its 8 corners are. O(samples).
CellMask find_truth(const Volume &volume, const TruthRule &rule);

} // namespace volsurf::bench
