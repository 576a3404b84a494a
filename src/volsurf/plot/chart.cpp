#include "volsurf/plot/chart.h"

#include "volsurf/plot/canvas.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace volsurf::plot {

namespace {

constexpr Colour kGridLine{0.88, 0.88, 0.88};
constexpr double kLabelSize = 14;
constexpr double kTickSize = 13;
constexpr double kTitleSize = 16;
constexpr double kMarkLabelGap = 6;

/// Where data go on the page.
struct Plane {
  const Chart &chart;
  Rectangle area;

  double x(double value) const { return area.left + area.width * position(chart.x, value); }
  double y(double value) const { return area.bottom() - area.height * position(chart.y, value); }
  Point at(const Point &point) const { return {x(point[0]), y(point[1])}; }
};

/// What is left of the chart's place for the data, between title and axes.
Rectangle data_area(const Rectangle &place, bool has_marks)
{
  const double above = has_marks ? 56 : 38;
  return {place.left + 92, place.top + above, place.width - 112, place.height - above - 52};
}

void draw_axes(Canvas &canvas, const Plane &plane)
{
  const Rectangle &area = plane.area;
  TextStyle style;
  style.size = kTickSize;
  style.align = Align::centre;
  for (const Tick &tick : ticks(plane.chart.x, static_cast<int>(area.width / 75))) {
    const double x = plane.x(tick.value);
    canvas.line({{x, area.top}, {x, area.bottom()}}, kGridLine, tick.label.empty() ? 0.5 : 1);
    canvas.text(tick.label, {x, area.bottom() + 18}, style);
  }
  style.align = Align::right;
  for (const Tick &tick : ticks(plane.chart.y, static_cast<int>(area.height / 30))) {
    const double y = plane.y(tick.value);
    canvas.line({{area.left, y}, {area.right(), y}}, kGridLine, tick.label.empty() ? 0.5 : 1);
    canvas.text(tick.label, {area.left - 8, y + 0.35 * kTickSize}, style);
  }
  canvas.frame(area, kGrey);
  style.size = kLabelSize;
  style.align = Align::centre;
  canvas.text(plane.chart.x.label, {area.left + area.width / 2, area.bottom() + 40}, style);
  style.upwards = true;
  canvas.text(plane.chart.y.label, {area.left - 70, area.top + area.height / 2}, style);
}

void draw_lines(Canvas &canvas, const Plane &plane)
{
  for (const Line &line : plane.chart.lines) {
    std::vector<Point> points;
    std::transform(line.points.begin(), line.points.end(), std::back_inserter(points),
                   [&](const Point &point) { return plane.at(point); });
    canvas.line(points, line.colour, 2);
  }
}

void draw_discs(Canvas &canvas, const Plane &plane, const Dots &dots)
{
  constexpr double kRadius = 4.5;
  for (const Point &point : dots.points)
    canvas.disc(plane.at(point), kRadius, dots.colour);
}

/// One square per place that has a dot, so that a hundred thousand dots make no large file; the more dots, the denser.
void draw_dots(Canvas &canvas, const Plane &plane, const Dots &dots)
{
  constexpr double kSquare = 3;
  constexpr std::array<int, 3> kDense{2, 5, 20};
  std::map<std::pair<int, int>, int> counts;
  for (const Point &point : dots.points) {
    const Point at = plane.at(point);
    if (at[0] >= plane.area.left && at[0] <= plane.area.right() && at[1] >= plane.area.top &&
        at[1] <= plane.area.bottom())
      ++counts[{static_cast<int>(at[0] / kSquare), static_cast<int>(at[1] / kSquare)}];
  }
  std::array<std::vector<Rectangle>, kDense.size() + 1> squares;
  for (const auto &[place, count] : counts) {
    const auto shade = static_cast<std::size_t>(std::upper_bound(kDense.begin(), kDense.end(), count) - kDense.begin());
    squares[shade].push_back({kSquare * place.first, kSquare * place.second, kSquare, kSquare});
  }
  for (std::size_t shade = 0; shade < squares.size(); ++shade)
    canvas.fill(squares[shade], dots.colour, 0.55 + 0.15 * static_cast<double>(shade));
}

/// Labels go above the data, in a row: to the right of their marks, or to the left where there is no room.
void draw_marks(Canvas &canvas, const Plane &plane)
{
  std::vector<Mark> marks = plane.chart.marks;
  std::sort(marks.begin(), marks.end(), [](const Mark &a, const Mark &b) { return a.x < b.x; });
  double occupied = plane.area.left;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Mark &mark = marks[i];
    const double x = plane.x(mark.x);
    canvas.line({{x, plane.area.top - 4}, {x, plane.area.bottom()}}, mark.colour, 1.5, true);
    TextStyle style;
    style.size = kTickSize;
    style.colour = mark.colour;
    const double width = canvas.text_width(mark.label, style);
    const double end = i + 1 < marks.size() ? plane.x(marks[i + 1].x) - kMarkLabelGap : plane.area.right();
    const bool has_room_left = x - kMarkLabelGap - width >= occupied;
    const bool goes_left = has_room_left && (x + width > end || i + 1 < marks.size());
    const double left = goes_left ? x - kMarkLabelGap - width
                                  : std::max(occupied, std::min(x + kMarkLabelGap, plane.area.right() - width));
    canvas.text(mark.label, {left, plane.area.top - 8}, style);
    occupied = std::max(left + width + kMarkLabelGap, x + kMarkLabelGap);
  }
}

/// Names of lines and dots, beside the title, where they hide no data.
void draw_legend(Canvas &canvas, const Plane &plane, double y)
{
  std::vector<std::pair<std::string, Colour>> entries;
  for (const Line &line : plane.chart.lines)
    entries.emplace_back(line.name, line.colour);
  for (const Dots &dots : plane.chart.dots)
    entries.emplace_back(dots.name, dots.colour);
  if (entries.size() < 2)
    return;
  TextStyle style;
  style.size = kTickSize;
  style.align = Align::right;
  double right = plane.area.right();
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
    canvas.text(entry->first, {right, y}, style);
    right -= canvas.text_width(entry->first, style) + 8;
    canvas.line({{right - 22, y - 4}, {right, y - 4}}, entry->second, 3);
    right -= 46;
  }
}

void draw_chart(Canvas &canvas, const Chart &chart, const Rectangle &place)
{
  const Plane plane{chart, data_area(place, !chart.marks.empty())};
  TextStyle style;
  style.size = kTitleSize;
  style.bold = true;
  canvas.text(chart.title, {plane.area.left, place.top + 20}, style);
  draw_axes(canvas, plane);
  canvas.clip(plane.area);
  for (const Dots &dots : chart.dots)
    if (dots.stand_out)
      draw_discs(canvas, plane, dots);
    else
      draw_dots(canvas, plane, dots);
  draw_lines(canvas, plane);
  canvas.unclip();
  draw_marks(canvas, plane);
  draw_legend(canvas, plane, place.top + 20);
}

void draw(Canvas &canvas, const Figure &figure, Size size)
{
  TextStyle style;
  style.size = 20;
  style.bold = true;
  double top = 0;
  if (!figure.title.empty()) {
    canvas.text(figure.title, {24, 36}, style);
    top = 50;
  }
  if (!figure.subtitle.empty()) {
    style.bold = false;
    style.size = kLabelSize;
    style.colour = kGrey;
    canvas.text(figure.subtitle, {24, top + 10}, style);
    top += 26;
  }
  const double height = (size.height - top) / static_cast<double>(figure.charts.size());
  for (const Chart &chart : figure.charts) {
    draw_chart(canvas, chart, {0, top, static_cast<double>(size.width), height});
    top += height;
  }
}

} // namespace

std::string draw_svg(const Figure &figure, Size size)
{
  Canvas canvas = Canvas::svg(size);
  draw(canvas, figure, size);
  return canvas.finish();
}

std::string draw_png(const Figure &figure, Size size, double scale)
{
  Canvas canvas = Canvas::png(size, scale);
  draw(canvas, figure, size);
  return canvas.finish();
}

} // namespace volsurf::plot
