#include "volsurf/topology/region_sizes.h"

namespace volsurf {

std::vector<std::int64_t> largest_region_sizes(const Hierarchy &hierarchy)
{
  std::vector<std::int64_t> cells = hierarchy.cell_counts;
  std::vector<std::int64_t> sizes(cells.size());
  const auto &by_rank = hierarchy.by_rank;
  // From the weakest up. Basins of one persistence leave together, so none of them holds another.
  for (std::size_t end = by_rank.size(); end > 0;) {
    const float persistence = hierarchy.persistence[by_rank[end - 1]];
    std::size_t begin = end;
    for (; begin > 0 && !(hierarchy.persistence[by_rank[begin - 1]] > persistence); --begin)
      sizes[by_rank[begin - 1]] = cells[by_rank[begin - 1]];
    for (; end > begin; --end) {
      const BasinId basin = by_rank[end - 1];
      if (hierarchy.ancestor[basin] != basin)
        cells[hierarchy.ancestor[basin]] += cells[basin];
    }
  }
  return sizes;
}

} // namespace volsurf
