// The choice of delta from the hierarchy alone: in the widest gap between the walls of large regions.
//
// In: the hierarchy, the noise of the gradient. Out: candidates for delta, the best first.
//
// Where two parts of the scan merge, the smaller one tells how much is at stake. Merges of large parts are few, and in
// the logarithm of their persistence they leave gaps: within a gap, delta changes next to nothing, so the regions there
// are what the scan itself consists of. Noise, on the other hand, merges its large regions all at once, below 0.72
// times its deviation in the gradient (its small ones last up to 1.7 times), and that is where the search ends. How
// large a part must be to count, 0.5 to 2 % of the scan, would be one more number to guess; so gaps are measured for
// several such numbers and their widths added. Where no region of that size stands out, the small ones of a small organ
// do, if they are above all noise. docs/automatic_delta.md shows the evidence and the failures.
#pragma once

#include "volsurf/topology/hierarchy.h"

namespace volsurf {

/// No wall that white noise makes has a larger persistence than this many of its deviations in the gradient.
constexpr double kNoiseFloor = 1.7;

/// A merge, as the basin that stops to be a region of its own tells of it.
struct Merge {
  double persistence; ///< finite
  std::int64_t cells; ///< of the smaller of the two regions that merge
};

/// All merges by decreasing persistence. O(basins).
std::vector<Merge> list_merges(const Hierarchy &hierarchy);

/// A gap between the walls of large regions: the regions differ little for all deltas in low < delta <= high.
struct DeltaCandidate {
  double low;
  double high;
  double width; ///< mean of ln(high / low) over what counts as large
  double delta; ///< in few digits
  double part;  ///< what counts as large, as a fraction of all cells: the middle of five numbers
  std::size_t regions;
};

/// At most `most` candidates, by decreasing width, ties to the larger delta; none where the field is constant. Gaps in
/// which delta cannot be rounded, narrower than 5 %, are left out but for the widest of all.
/// `noise_in_gradient` is NoiseLevel::gradient. `place` says where in its gap each delta is, in the logarithm: 0 .. 1
/// from low to high, within 5 %. O(basins log basins).
std::vector<DeltaCandidate> find_delta_candidates(const Hierarchy &hierarchy, double noise_in_gradient,
                                                  std::size_t most, double place);

/// The number in low < x <= high with the fewest digits, near the geometric middle. 0 < low < high.
double short_number_between(double low, double high);

} // namespace volsurf
