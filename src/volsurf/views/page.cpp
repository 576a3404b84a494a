#include "volsurf/views/page.h"

#include "volsurf/views/charts.h"
#include "volsurf/views/choices.h"
#include "volsurf/views/numbers.h"

#include <openssl/evp.h>

#include <cmath>
#include <sstream>

namespace volsurf::views {

namespace {

constexpr char kStyle[] = R"(
body { font: 17px/1.5 system-ui, "DejaVu Sans", sans-serif; color: #1a1a1a; max-width: 60rem; margin: 2rem auto;
       padding: 0 1rem; }
h1 { font-size: 1.6rem; line-height: 1.2; }
h2 { font-size: 1.25rem; margin: 2.2rem 0 .4rem; }
img { width: 100%; height: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; margin: .8rem 0; }
th, td { padding: .2rem .9rem; text-align: right; border-bottom: 1px solid #ddd; }
th { border-bottom: 2px solid #888; vertical-align: bottom; }
td.words, th.words { text-align: left; }
tr.marked { background: #e8f4ef; font-weight: bold; }
pre { background: #f3f3f3; padding: .6rem .8rem; white-space: pre-wrap; overflow-wrap: anywhere; margin: .5rem 0 0; }
p.reason { margin: .1rem 0 1rem .8rem; }
footer { margin-top: 2.5rem; border-top: 1px solid #ddd; color: #444; font-size: .9rem; overflow-wrap: anywhere; }
@media print {
  body { font-size: 11pt; max-width: none; margin: 0; }
  figure, table, pre, section { break-inside: avoid; }
  pre { border: 1px solid #888; }
}
figure { margin: .5rem 0 0; }
)";

/// Text as HTML shows it.
std::string escaped(const std::string &text)
{
  std::string result;
  for (const char c : text)
    switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  return result;
}

std::string base64(const std::string &bytes)
{
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int length =
      EVP_EncodeBlock(reinterpret_cast<unsigned char *>(text.data()),
                      reinterpret_cast<const unsigned char *>(bytes.data()), static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

/// An SVG as a picture of its own, so that the names inside of several do not clash.
void write_chart(std::ostream &out, const plot::Chart &chart, const std::string &explanation)
{
  plot::Chart untitled = chart;
  untitled.title.clear();
  out << "<section>\n<h2>" << escaped(chart.title) << "</h2>\n<p>" << explanation << "</p>\n<figure><img alt=\""
      << escaped(chart.title) << "\" src=\"data:image/svg+xml;base64,"
      << base64(plot::draw_svg({"", "", {untitled}}, {900, 400})) << "\"></figure>\n</section>\n";
}

void write_rows(std::ostream &out, const Exploration &exploration)
{
  out << "<section>\n<h2>In numbers</h2>\n<p>Above a delta of " << significant(exploration.largest_persistence(), 4)
      << " intensity per mm there is no surface.</p>\n<table>\n<tr><th>delta,<br>intensity/mm</th><th>regions</th>"
         "<th>components</th><th>area, cm\u00B2</th><th class=\"words\"></th></tr>\n";
  for (const DeltaRow &row : delta_rows(exploration))
    out << "<tr" << (row.note.empty() ? "" : " class=\"marked\"") << "><td>" << significant(row.delta, 4) << "</td><td>"
        << grouped(row.regions) << "</td><td>" << grouped(row.components) << "</td><td>"
        << grouped(std::llround(row.area_mm2 / 100)) << "</td><td class=\"words\">" << escaped(row.note)
        << "</td></tr>\n";
  out << "</table>\n</section>\n";
}

void write_region(std::ostream &out, const NotableRegion &region)
{
  out << "<tr><td>" << significant_below(region.persistence, 4) << "</td><td>"
      << significant(region.volume_mm3 / 1000, 4) << "</td><td>" << significant(region.point_mm[0], 5) << ','
      << significant(region.point_mm[1], 5) << ',' << significant(region.point_mm[2], 5) << "</td><td class=\"words\">"
      << (region.is_background ? "background" : "") << "</td></tr>\n";
}

void write_regions(std::ostream &out, const std::string &title, const std::string &explanation,
                   const std::vector<NotableRegion> &regions, Frame frame)
{
  out << "<section>\n<h2>" << title << "</h2>\n<p>" << explanation
      << "</p>\n<table>\n<tr><th>up to delta</th><th>volume, ml</th><th>a point in it, mm "
      << (frame == Frame::ras ? "RAS" : "LPS") << "</th><th class=\"words\"></th></tr>\n";
  for (const NotableRegion &region : regions)
    write_region(out, region);
  out << "</table>\n</section>\n";
}

void write_suggestions(std::ostream &out, const Exploration &exploration)
{
  out << "<section>\n<h2>What to type next</h2>\n";
  for (const Suggestion &suggestion : suggestions(exploration))
    out << "<pre>" << escaped(suggestion.command) << "</pre>\n<p class=\"reason\">" << escaped(suggestion.reason)
        << "</p>\n";
  out << "</section>\n";
}

} // namespace

std::string to_html(const Exploration &exploration)
{
  const std::string name = escaped(exploration.settings.input.filename().string());
  std::ostringstream out;
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>"
      << name << ": what each delta gives</title>\n<style>" << kStyle << "</style>\n</head>\n<body>\n<h1>" << name
      << ": what each delta gives</h1>\n<p>" << escaped(headline(exploration))
      << ".</p>\n<p><b>delta</b> is the contrast per millimetre that a wall must keep even at its weakest point. Small "
         "deltas keep every wall, those that noise makes too; large ones only the strongest.</p>\n";
  write_chart(
      out, regions_chart(exploration),
      "The volume falls into regions, and the walls between them form connected surfaces, the components. Where "
      "a curve is flat the choice of delta hardly matters; left of the noise floor, what comes and goes may be "
      "noise alone.");
  write_chart(
      out, area_chart(exploration),
      "The area of all walls together, on the voxels' faces. A sudden step is a large wall that gives way: stay "
      "to the left of it to keep that wall.");
  write_chart(
      out, volumes_chart(exploration),
      "Each dot is a region: to the right those with strong walls, at the top the large ones. A delta keeps the "
      "dots to its right; those above and to the right of the crowd are what the scan shows clearly.");
  write_rows(out, exploration);
  const Frame frame = exploration.settings.frame;
  write_regions(
      out, "Prominent regions",
      "Strong walls around much: the orange dots of the chart, by persistence times radius. Each is a region of "
      "its own for every delta up to the one in the first column, and has this volume there; with its point, "
      "<code>--seed=X,Y,Z</code> takes it alone.",
      exploration.prominent, frame);
  write_regions(out, "The strongest regions", "Those with the strongest walls, however small they are.",
                exploration.strongest, frame);
  write_suggestions(out, exploration);
  out << "<footer><p>" << escaped(version_text()) << ", from " << name << ", SHA-256 "
      << escaped(exploration.source.sha256) << "</p></footer>\n</body>\n</html>\n";
  return out.str();
}

} // namespace volsurf::views
