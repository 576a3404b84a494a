#include "volsurf/plot/chart.h"

#include "support/contains.h"

#include "volsurf/core/error.h"

#include <gtest/gtest.h>

using namespace volsurf;
using namespace volsurf::plot;

namespace {

Figure small_figure()
{
  Chart chart;
  chart.title = "a title";
  chart.x = {"x", Scale::logarithmic, 1, 100};
  chart.y = {"y", Scale::linear, 0, 10};
  chart.lines = {{"line", kBlue, {{1, 1}, {10, 5}, {1000, 9}}}};
  chart.dots = {{"dots", kOrange, {{2, 2}, {2, 2}, {-1, 3}}, false}, {"discs", kGreen, {{50, 5}}, true}};
  chart.marks = {{9, "nine", kGrey}, {11, "eleven", kGreen}};
  return {"figure", "subtitle", {chart, chart}};
}

std::uint32_t big_endian_at(const std::string &bytes, std::size_t at)
{
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

} // namespace

TEST(Chart, PngHasTheScaledSize)
{
  const std::string png = draw_png(small_figure(), {300, 400}, 2);
  ASSERT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(big_endian_at(png, 16), 600U);
  EXPECT_EQ(big_endian_at(png, 20), 800U);
}

TEST(Chart, SvgIsWholeAndHoldsTheColoursOfItsData)
{
  const std::string svg = draw_svg(small_figure(), {300, 400});
  EXPECT_TRUE(test::contains(svg, "<svg"));
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  EXPECT_TRUE(test::contains(svg, "0%,44.7%,69.8%")) << "blue";
  EXPECT_TRUE(test::contains(svg, "83.5%,36.9%,0%")) << "orange";
}

TEST(Chart, IsTheSameBytesEachTime)
{
  EXPECT_TRUE(draw_png(small_figure(), {300, 400}, 1) == draw_png(small_figure(), {300, 400}, 1));
  EXPECT_TRUE(draw_svg(small_figure(), {300, 400}) == draw_svg(small_figure(), {300, 400}));
}

TEST(Chart, ThatIsTooLargeForCairoIsAnError)
{
  EXPECT_THROW(draw_png(small_figure(), {300, 400}, 1000), Error);
}
