#include "volsurf/surface/sheets.h"

#include "volsurf/core/star.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

namespace volsurf {

namespace {

bool has_bit(unsigned set, int bit)
{
  return (set >> bit & 1U) != 0;
}

unsigned star_faces_of(unsigned inside)
{
  unsigned faces = 0;
  for (int f = 0; f < 12; ++f) {
    faces |= static_cast<unsigned>(has_bit(inside, lower_octant(f)) != has_bit(inside, upper_octant(f))) << f;
  }
  return faces;
}

/// The faces of the pattern that have the star edge as a side.
std::vector<int> faces_at_edge(unsigned faces, int edge)
{
  std::vector<int> result;
  for (int f = 0; f < 12; ++f) {
    const bool at_edge = f / 4 != edge / 2 && (lower_octant(f) >> (edge / 2) & 1) == (edge & 1);
    if (at_edge && has_bit(faces, f))
      result.push_back(f);
  }
  return result;
}

/// Small sets of star faces.
class FaceGroups {
public:
  FaceGroups() { std::iota(group_.begin(), group_.end(), 0); }
  void join(int f, int g)
  {
    const int from = group_[g];
    std::replace(group_.begin(), group_.end(), from, group_[f]);
  }
  int of(int f) const { return group_[f]; }

private:
  std::array<int, 12> group_{};
};

int inside_octant(unsigned inside, int f)
{
  return has_bit(inside, lower_octant(f)) ? lower_octant(f) : upper_octant(f);
}

FaceGroups sheets_of(unsigned inside)
{
  FaceGroups sheets;
  for (int edge = 0; edge < kStarEdges; ++edge) {
    const auto faces = faces_at_edge(star_faces_of(inside), edge);
    for (std::size_t i = 1; i < faces.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (faces.size() == 2 || inside_octant(inside, faces[i]) == inside_octant(inside, faces[j]))
          sheets.join(faces[i], faces[j]);
  }
  return sheets;
}

std::array<std::uint8_t, 12> numbered(const FaceGroups &groups, unsigned faces)
{
  std::array<std::uint8_t, 12> sheet{};
  sheet.fill(kNoSheet);
  std::vector<int> seen;
  for (int f = 0; f < 12; ++f) {
    if (!has_bit(faces, f))
      continue;
    const auto found = std::find(seen.begin(), seen.end(), groups.of(f));
    sheet[f] = static_cast<std::uint8_t>(found - seen.begin());
    if (found == seen.end())
      seen.push_back(groups.of(f));
  }
  return sheet;
}

std::uint8_t pinched_edges(const FaceGroups &sheets, unsigned faces)
{
  unsigned pinched = 0;
  for (int edge = 0; edge < kStarEdges; ++edge) {
    const auto around = faces_at_edge(faces, edge);
    const bool one_sheet =
        std::all_of(around.begin(), around.end(), [&](int f) { return sheets.of(f) == sheets.of(around.front()); });
    pinched |= static_cast<unsigned>(around.size() == 4 && one_sheet) << edge;
  }
  return static_cast<std::uint8_t>(pinched);
}

bool pattern_may_split(unsigned faces)
{
  FaceGroups connected;
  for (int edge = 0; edge < kStarEdges; ++edge) {
    const auto around = faces_at_edge(faces, edge);
    if (around.size() == 4)
      return true;
    for (std::size_t i = 1; i < around.size(); ++i)
      connected.join(around[0], around[i]);
  }
  const auto sheet = numbered(connected, faces);
  return std::any_of(sheet.begin(), sheet.end(), [](std::uint8_t s) { return s != 0 && s != kNoSheet; });
}

std::unique_ptr<SheetTables> make_tables()
{
  auto tables = std::make_unique<SheetTables>();
  for (unsigned inside = 0; inside < 256; ++inside) {
    const FaceGroups sheets = sheets_of(inside);
    tables->sheet[inside] = numbered(sheets, star_faces_of(inside));
    tables->pinched[inside] = pinched_edges(sheets, star_faces_of(inside));
  }
  for (unsigned faces = 0; faces < 4096; ++faces)
    tables->may_split[faces] = pattern_may_split(faces);
  return tables;
}

} // namespace

const SheetTables &sheet_tables()
{
  static const std::unique_ptr<SheetTables> tables = make_tables();
  return *tables;
}

} // namespace volsurf
