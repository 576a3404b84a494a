#include "volsurf/plot/canvas.h"

#include "volsurf/core/error.h"

#include <cairo-svg.h>
#include <cairo.h>

namespace volsurf::plot {

namespace {

cairo_status_t append(void *bytes, const unsigned char *data, unsigned length)
{
  static_cast<std::string *>(bytes)->append(reinterpret_cast<const char *>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void require_success(cairo_status_t status)
{
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(std::string("a chart could not be drawn: ") + cairo_status_to_string(status));
}

void set_colour(cairo_t *context, Colour colour, double opacity = 1)
{
  cairo_set_source_rgba(context, colour.red, colour.green, colour.blue, opacity);
}

/// cairo names the group around all of an SVG by how many surfaces the process has made so far. Nothing uses the name.
void remove_name_of_page(std::string &svg)
{
  const std::string start = " id=\"surface";
  const std::size_t begin = svg.find(start);
  if (begin != std::string::npos)
    svg.erase(begin, svg.find('"', begin + start.size()) + 1 - begin);
}

} // namespace

struct Canvas::Page {
  std::string bytes;
  cairo_surface_t *surface = nullptr;
  cairo_t *context = nullptr;
  bool is_png = false;

  Page() = default;
  Page(const Page &) = delete;
  Page &operator=(const Page &) = delete;
  ~Page()
  {
    cairo_destroy(context);
    cairo_surface_destroy(surface);
  }

  void begin()
  {
    context = cairo_create(surface);
    cairo_set_source_rgb(context, 1, 1, 1);
    cairo_paint(context);
  }
};

Canvas::Canvas(std::unique_ptr<Page> page) : page_(std::move(page)) {}
Canvas::Canvas(Canvas &&) noexcept = default;
Canvas::~Canvas() = default;

Canvas Canvas::svg(Size size)
{
  auto page = std::make_unique<Page>();
  page->surface = cairo_svg_surface_create_for_stream(append, &page->bytes, size.width, size.height);
  page->begin();
  return Canvas(std::move(page));
}

Canvas Canvas::png(Size size, double scale)
{
  auto page = std::make_unique<Page>();
  page->is_png = true;
  page->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(size.width * scale),
                                             static_cast<int>(size.height * scale));
  page->begin();
  cairo_scale(page->context, scale, scale);
  return Canvas(std::move(page));
}

void Canvas::line(const std::vector<Point> &points, Colour colour, double width, bool dashed)
{
  constexpr double kDash = 5;
  cairo_t *const context = page_->context;
  for (const Point &point : points)
    cairo_line_to(context, point[0], point[1]);
  cairo_set_dash(context, &kDash, dashed ? 1 : 0, 0);
  cairo_set_line_width(context, width);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  set_colour(context, colour);
  cairo_stroke(context);
}

void Canvas::fill(const std::vector<Rectangle> &rectangles, Colour colour, double opacity)
{
  for (const Rectangle &r : rectangles)
    cairo_rectangle(page_->context, r.left, r.top, r.width, r.height);
  set_colour(page_->context, colour, opacity);
  cairo_fill(page_->context);
}

void Canvas::disc(Point centre, double radius, Colour colour)
{
  constexpr double kFullTurn = 6.283185307179586;
  cairo_t *const context = page_->context;
  cairo_new_sub_path(context);
  cairo_arc(context, centre[0], centre[1], radius, 0, kFullTurn);
  set_colour(context, colour);
  cairo_fill_preserve(context);
  cairo_set_dash(context, nullptr, 0, 0);
  cairo_set_line_width(context, 1);
  set_colour(context, {1, 1, 1});
  cairo_stroke(context);
}

void Canvas::frame(const Rectangle &r, Colour colour)
{
  cairo_rectangle(page_->context, r.left, r.top, r.width, r.height);
  cairo_set_dash(page_->context, nullptr, 0, 0);
  cairo_set_line_width(page_->context, 1);
  set_colour(page_->context, colour);
  cairo_stroke(page_->context);
}

void Canvas::choose_font(const TextStyle &style)
{
  cairo_select_font_face(page_->context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(page_->context, style.size);
}

double Canvas::text_width(const std::string &words, const TextStyle &style)
{
  choose_font(style);
  cairo_text_extents_t extents;
  cairo_text_extents(page_->context, words.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(const std::string &words, Point at, const TextStyle &style)
{
  constexpr double kQuarter = 1.5707963267948966;
  const double width = text_width(words, style);
  cairo_t *const context = page_->context;
  cairo_save(context);
  cairo_translate(context, at[0], at[1]);
  if (style.upwards)
    cairo_rotate(context, -kQuarter);
  cairo_move_to(context, style.align == Align::left ? 0 : style.align == Align::right ? -width : -width / 2, 0);
  set_colour(context, style.colour);
  cairo_show_text(context, words.c_str());
  cairo_restore(context);
  cairo_new_path(context);
}

void Canvas::clip(const Rectangle &r)
{
  cairo_save(page_->context);
  cairo_rectangle(page_->context, r.left, r.top, r.width, r.height);
  cairo_clip(page_->context);
}

void Canvas::unclip()
{
  cairo_restore(page_->context);
}

std::string Canvas::finish()
{
  require_success(cairo_status(page_->context));
  if (page_->is_png)
    require_success(cairo_surface_write_to_png_stream(page_->surface, append, &page_->bytes));
  cairo_surface_finish(page_->surface);
  require_success(cairo_surface_status(page_->surface));
  if (!page_->is_png)
    remove_name_of_page(page_->bytes);
  return std::move(page_->bytes);
}

} // namespace volsurf::plot
