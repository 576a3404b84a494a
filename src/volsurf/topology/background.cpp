#include "volsurf/topology/background.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace volsurf {

namespace {

/// Adds to each basin's faces those of all that fell off it: what falls off with it. Returns the basins that have any,
/// by rank. O(basins at the border and their ancestors, times their logarithm): of a large volume few, and a pass over
/// all basins by rank would wait for memory at each.
std::vector<BasinId> add_to_ancestors(const Hierarchy &hierarchy, std::vector<std::int64_t> &faces)
{
  std::vector<std::uint32_t> ranks;
  for (BasinId basin = 0; basin < faces.size(); ++basin)
    if (faces[basin] > 0)
      ranks.push_back(hierarchy.rank[basin]);
  std::priority_queue<std::uint32_t> weakest_first({}, std::move(ranks));
  std::vector<BasinId> basins;
  while (!weakest_first.empty()) {
    const BasinId basin = hierarchy.by_rank[weakest_first.top()];
    weakest_first.pop();
    basins.push_back(basin);
    const BasinId ancestor = hierarchy.ancestor[basin];
    if (ancestor == basin)
      continue;
    if (faces[ancestor] == 0)
      weakest_first.push(hierarchy.rank[ancestor]);
    faces[ancestor] += faces[basin];
  }
  std::reverse(basins.begin(), basins.end());
  return basins;
}

} // namespace

std::vector<std::int64_t> count_border_faces(const CellLabels &cells, std::size_t basins)
{
  std::vector<std::int64_t> faces(basins);
  for (std::int64_t z = 0, cell = 0; z < cells.size[2]; ++z)
    for (std::int64_t y = 0; y < cells.size[1]; ++y) {
      const int row_faces = (z == 0) + (z == cells.size[2] - 1) + (y == 0) + (y == cells.size[1] - 1);
      const auto count = [&](std::int64_t x, int border_faces) { faces[cells.basins[cell + x]] += border_faces; };
      if (row_faces > 0)
        for (std::int64_t x = 0; x < cells.size[0]; ++x)
          count(x, row_faces);
      count(0, 1);
      count(cells.size[0] - 1, 1);
      cell += cells.size[0];
    }
  return faces;
}

BasinId find_background(const Hierarchy &hierarchy, std::vector<std::int64_t> border_faces)
{
  auto &faces_with_parts = border_faces;
  const std::vector<BasinId> strongest_first = add_to_ancestors(hierarchy, faces_with_parts);
  BasinId background = hierarchy.by_rank.front();
  std::int64_t faces = faces_with_parts[background];
  for (const BasinId part : strongest_first) {
    if (part == background || hierarchy.ancestor[part] != background)
      continue;
    faces -= faces_with_parts[part];
    if (faces_with_parts[part] > faces) {
      background = part;
      faces = faces_with_parts[part];
    }
  }
  return background;
}

} // namespace volsurf
