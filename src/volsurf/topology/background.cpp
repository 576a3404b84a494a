#include "volsurf/topology/background.h"

namespace volsurf {

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
  // From the weakest up: what falls off with a basin has its own faces and those of all that fell off it before.
  auto &faces_with_parts = border_faces;
  for (auto basin = hierarchy.by_rank.rbegin(); basin + 1 != hierarchy.by_rank.rend(); ++basin)
    faces_with_parts[hierarchy.ancestor[*basin]] += faces_with_parts[*basin];

  BasinId background = hierarchy.by_rank.front();
  std::int64_t faces = faces_with_parts[background];
  for (const BasinId part : hierarchy.by_rank) {
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
