// Charts as pictures: PNG and SVG by the same drawing code, without a display.
//
// In: charts as plain data. Out: the bytes of a file, the same for the same charts. By cairo.
#pragma once

#include "volsurf/plot/axis.h"

#include <array>

namespace volsurf::plot {

using Point = std::array<double, 2>;

struct Colour {
  double red;
  double green;
  double blue;
};

// Apart for the colour-blind, too: Okabe and Ito, "Color universal design", 2008.
constexpr Colour kBlue{0.0, 0.447, 0.698};
constexpr Colour kOrange{0.835, 0.369, 0.0};
constexpr Colour kGreen{0.0, 0.5, 0.37};
constexpr Colour kGrey{0.35, 0.35, 0.35};

/// A polyline. Points outside the axes are cut off.
struct Line {
  std::string name;
  Colour colour;
  std::vector<Point> points;
};

/// Many points, where the colour is denser the closer they lie; or a few that stand out, as discs.
struct Dots {
  std::string name;
  Colour colour;
  std::vector<Point> points;
  bool stand_out = false;
};

/// A vertical line across the chart.
struct Mark {
  double x;
  std::string label;
  Colour colour;
};

struct Chart {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Line> lines;
  std::vector<Dots> dots;
  std::vector<Mark> marks; ///< their labels are placed beside each other
};

/// Charts below each other.
struct Figure {
  std::string title;    ///< empty: none
  std::string subtitle; ///< likewise
  std::vector<Chart> charts;
};

struct Size {
  int width;
  int height;
};

/// The bytes of a file; `size` in SVG units or, times `scale`, in pixels. Throws Error where cairo fails.
std::string draw_svg(const Figure &figure, Size size);
std::string draw_png(const Figure &figure, Size size, double scale);

} // namespace volsurf::plot
