#include "volsurf/views/charts.h"

#include "volsurf/views/choices.h"
#include "volsurf/views/numbers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace volsurf::views {

namespace {

using plot::Axis;
using plot::Chart;
using plot::Point;
using plot::Scale;

Axis delta_axis(const Exploration &exploration)
{
  const DeltaRange range = shown_range(exploration);
  return {"delta, intensity per mm", Scale::logarithmic, range.low, range.high};
}

/// A curve of steps, which falls after each delta of a persistence, at places that a chart can tell apart.
std::vector<Point> steps(const Axis &axis, const std::function<double(double)> &value_at)
{
  constexpr int kPlaces = 1200;
  std::vector<Point> points;
  for (int i = 0; i <= kPlaces; ++i) {
    const double delta = axis.low * std::pow(axis.high / axis.low, i / static_cast<double>(kPlaces));
    const double value = value_at(delta);
    if (!points.empty() && points.back()[1] != value)
      points.push_back({delta, points.back()[1]});
    points.push_back({delta, value});
  }
  return points;
}

/// Whole powers of ten around the values, at least one.
Axis powers_around(const std::string &label, double smallest, double largest)
{
  const double low = std::floor(std::log10(smallest));
  const double high = std::max(std::ceil(std::log10(largest) + 0.05), low + 1);
  return {label, Scale::logarithmic, std::pow(10.0, low), std::pow(10.0, high)};
}

std::vector<plot::Mark> known_marks(const Exploration &exploration)
{
  std::vector<plot::Mark> marks;
  if (const auto floor = exploration.noise_floor())
    marks.push_back({*floor, "noise floor " + significant(*floor, 3), plot::kGrey});
  if (const auto automatic = exploration.automatic_delta())
    marks.push_back({*automatic, "--delta auto: " + significant(*automatic, 4), plot::kGreen});
  return marks;
}

} // namespace

Chart regions_chart(const Exploration &exploration)
{
  const BoundaryCurve &curve = exploration.curve;
  Chart chart;
  chart.title = "Regions and connected surfaces";
  chart.x = delta_axis(exploration);
  chart.y = powers_around("number", 1, static_cast<double>(curve.regions_at(chart.x.low)));
  chart.y.low = 0.8; // so that a line at 1 can be seen
  chart.lines = {{"regions", plot::kBlue,
                  steps(chart.x, [&](double delta) { return static_cast<double>(curve.regions_at(delta)); })},
                 {"components of the boundary", plot::kOrange, steps(chart.x, [&](double delta) {
                    return std::max(0.5, static_cast<double>(curve.components_at(delta)));
                  })}};
  chart.marks = known_marks(exploration);
  return chart;
}

Chart area_chart(const Exploration &exploration)
{
  const BoundaryCurve &curve = exploration.curve;
  constexpr double kMm2PerCm2 = 100;
  const double largest = curve.area_at(exploration.largest_persistence()) / kMm2PerCm2;
  Chart chart;
  chart.title = "Area of the boundary";
  chart.x = delta_axis(exploration);
  chart.y = powers_around("area, cm\u00B2", largest, curve.area_at(chart.x.low) / kMm2PerCm2);
  chart.lines = {{"area", plot::kBlue, steps(chart.x, [&](double delta) {
                    return std::max(curve.area_at(delta) / kMm2PerCm2, 0.5 * chart.y.low);
                  })}};
  chart.marks = known_marks(exploration);
  return chart;
}

Chart volumes_chart(const Exploration &exploration)
{
  constexpr double kMm3PerMl = 1000;
  Chart chart;
  chart.title = "Strength and volume of every region";
  chart.x = delta_axis(exploration);
  plot::Dots dots{"regions", plot::kBlue, {}, false};
  double largest = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t rank = 1; rank < exploration.volumes_mm3.size(); ++rank) {
    const double volume_ml = exploration.volumes_mm3[rank] / kMm3PerMl;
    const double persistence = exploration.curve.persistence[rank];
    if (persistence < chart.x.low || volume_ml <= 0)
      continue;
    dots.points.push_back({persistence, volume_ml});
    largest = std::max(largest, volume_ml);
    smallest = std::min(smallest, volume_ml);
  }
  chart.y = {"volume, ml", Scale::logarithmic, smallest / 2, largest * 2};
  chart.x.label = "persistence: the largest delta that keeps the region, intensity per mm";
  chart.dots.push_back(std::move(dots));
  chart.dots.push_back({"prominent regions", plot::kOrange, {}, true});
  for (const NotableRegion &region : exploration.prominent)
    chart.dots.back().points.push_back({region.persistence, region.volume_mm3 / kMm3PerMl});
  chart.marks = known_marks(exploration);
  return chart;
}

std::string to_png(const Exploration &exploration)
{
  plot::Figure figure;
  figure.title = exploration.settings.input.filename().string() + ": what each delta gives";
  figure.subtitle = headline(exploration);
  figure.charts = {regions_chart(exploration), area_chart(exploration), volumes_chart(exploration)};
  return draw_png(figure, {900, 1260}, 2);
}

} // namespace volsurf::views
