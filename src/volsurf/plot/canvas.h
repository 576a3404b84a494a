// What of cairo the charts need.
#pragma once

#include "volsurf/plot/chart.h"

#include <memory>

namespace volsurf::plot {

struct Rectangle {
  double left;
  double top;
  double width;
  double height;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

enum class Align { left, centre, right };

struct TextStyle {
  double size = 13;
  Colour colour{0.1, 0.1, 0.1};
  Align align = Align::left;
  bool bold = false;
  bool upwards = false; ///< turned by a quarter, to be read from below
};

/// A white page. Coordinates are those of its size, from its upper left corner.
class Canvas {
public:
  static Canvas svg(Size size);
  static Canvas png(Size size, double scale);
  Canvas(Canvas &&) noexcept;
  Canvas &operator=(Canvas &&) = delete;
  Canvas(const Canvas &) = delete;
  Canvas &operator=(const Canvas &) = delete;
  ~Canvas();

  void line(const std::vector<Point> &points, Colour colour, double width, bool dashed = false);
  void fill(const std::vector<Rectangle> &rectangles, Colour colour, double opacity = 1);
  void disc(Point centre, double radius, Colour colour); ///< with a white rim
  void frame(const Rectangle &rectangle, Colour colour);

  /// `at` is the end of the base line that the alignment names.
  void text(const std::string &words, Point at, const TextStyle &style);
  double text_width(const std::string &words, const TextStyle &style);

  /// What is drawn until unclip() shows within the rectangle only.
  void clip(const Rectangle &rectangle);
  void unclip();

  /// The bytes of the file. Throws Error where anything has failed.
  std::string finish();

private:
  struct Page;
  explicit Canvas(std::unique_ptr<Page> page);
  void choose_font(const TextStyle &style);
  std::unique_ptr<Page> page_;
};

} // namespace volsurf::plot
