#include "volsurf/views/text.h"

#include "volsurf/views/choices.h"
#include "volsurf/views/numbers.h"

#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace volsurf::views {

namespace {

void print_rows(const Exploration &exploration, std::ostream &out)
{
  out << std::setw(12) << "delta" << std::setw(12) << "regions" << std::setw(12) << "components" << std::setw(14)
      << "area mm2" << '\n';
  for (const DeltaRow &row : delta_rows(exploration)) {
    out << std::setw(12) << significant(row.delta, 4) << std::setw(12) << row.regions << std::setw(12) << row.components
        << std::setw(14) << significant(std::round(row.area_mm2), 9);
    if (!row.note.empty())
      out << "   " << row.note;
    out << '\n';
  }
}

void print_regions(const std::vector<NotableRegion> &regions, Frame frame, std::ostream &out)
{
  out << std::setw(12) << "up to delta" << std::setw(14) << "volume mm3"
      << "   a point in it, mm " << (frame == Frame::ras ? "RAS" : "LPS") << '\n';
  for (const NotableRegion &region : regions)
    out << std::setw(12) << significant_below(region.persistence, 4) << std::setw(14)
        << significant(std::round(region.volume_mm3), 9) << "   " << significant(region.point_mm[0], 5) << ','
        << significant(region.point_mm[1], 5) << ',' << significant(region.point_mm[2], 5)
        << (region.is_background ? "   background" : "") << '\n';
}

} // namespace

std::string to_text(const Exploration &exploration)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << exploration.settings.input.string() << ": " << headline(exploration) << "\n\n"
      << "What each delta (intensity per mm) gives. Above " << significant(exploration.largest_persistence(), 4)
      << " there is no surface.\n\n";
  print_rows(exploration, out);
  const Frame frame = exploration.settings.frame;
  out << "\nProminent regions: strong walls around much. Volumes are those at the largest delta that keeps the "
         "region.\n\n";
  print_regions(exploration.prominent, frame, out);
  out << "\nThe strongest regions, however small.\n\n";
  print_regions(exploration.strongest, frame, out);
  out << "\nWhat to type next\n\n";
  for (const Suggestion &suggestion : suggestions(exploration))
    out << "    " << suggestion.command << "\n        " << suggestion.reason << '\n';
  return out.str();
}

std::string to_csv(const BoundaryCurve &curve)
{
  constexpr std::size_t kAllOf = 1000;
  constexpr double kClosest = 0.999;
  constexpr int kDeltaDigits = std::numeric_limits<float>::max_digits10;
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << "delta,regions,components,faces,area_mm2\n";
  double last = std::numeric_limits<double>::infinity();
  for (std::size_t rank = 1; rank < curve.persistence.size(); ++rank) {
    const double delta = curve.persistence[rank];
    const bool is_far = rank <= kAllOf ? delta < last : delta < kClosest * last;
    if (!(delta > 0) || !is_far)
      continue;
    last = delta;
    out << significant_below(delta, kDeltaDigits) << ',' << curve.regions_at(delta) << ',' << curve.components_at(delta)
        << ',' << curve.faces_at(delta) << ',' << significant(curve.area_at(delta), 12) << '\n';
  }
  return out.str();
}

} // namespace volsurf::views
