#include "volsurf/pipeline/segments.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace volsurf {

namespace {

/// To three digits, in millilitres or, below a tenth of one, in mm^3.
std::string volume_text(double mm3)
{
  const bool in_ml = mm3 >= 100;
  const double value = in_ml ? mm3 / 1000 : mm3;
  const int digits_before = value > 0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
  std::ostringstream out;
  out.precision(std::clamp(3 - digits_before, 0, 3));
  out << std::fixed << value << (in_ml ? " ml" : " mm3");
  return out.str();
}

} // namespace

std::vector<Segment> make_segments(const Selection &selection, const Regions &regions, const Grid &grid)
{
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < std::min(kMostSegments, selection.regions.size()); ++i) {
    const RegionId region = selection.regions[i];
    const double mm3 = static_cast<double>(regions.cell_counts[region - 1]) * voxel_volume_mm3(grid);
    segments.push_back({region, "region " + std::to_string(region) + " (" + volume_text(mm3) + ")"});
  }
  return segments;
}

void keep_segments(const std::vector<Segment> &segments, LabelVolume &labels)
{
  std::vector<bool> kept(segments.empty() ? 0 : segments.back().label + 1); // they ascend
  for (const Segment &segment : segments)
    kept[segment.label] = true;
  for (std::uint32_t &label : labels.labels)
    if (label >= kept.size() || !kept[label])
      label = 0;
}

} // namespace volsurf
