#include "volsurf/topology/label_merge.h"

#include "volsurf/topology/background.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace volsurf {

namespace {

constexpr BasinId kNoBasin = std::numeric_limits<BasinId>::max();

/// Sets the basin of each cell, and the first cell and the number of cells of each basin. Returns the basin of each
/// label.
std::vector<BasinId> number_basins(const std::vector<std::uint32_t> &labels, RegionMerge &merge)
{
  Hierarchy &hierarchy = merge.hierarchy;
  std::vector<BasinId> of_label(static_cast<std::size_t>(*std::max_element(labels.begin(), labels.end())) + 1,
                                kNoBasin);
  for (std::size_t cell = 0; cell < labels.size(); ++cell) {
    BasinId &basin = of_label[labels[cell]];
    if (basin == kNoBasin) {
      basin = static_cast<BasinId>(hierarchy.roots.size());
      hierarchy.roots.push_back(static_cast<CellId>(cell));
      hierarchy.cell_counts.push_back(0);
    }
    ++hierarchy.cell_counts[basin];
    merge.cells.basins[static_cast<std::int64_t>(cell)] = basin;
  }
  return of_label;
}

BasinId most_at_the_border(const RegionMerge &merge)
{
  const auto faces = count_border_faces(merge.cells, merge.hierarchy.roots.size());
  return static_cast<BasinId>(std::max_element(faces.begin(), faces.end()) - faces.begin());
}

} // namespace

RegionMerge merge_of_labels(const LabelVolume &labels)
{
  RegionMerge merge{{labels.grid.size, Buffer<BasinId>(labels.grid.sample_count())}, {}};
  const std::vector<BasinId> of_label = number_basins(labels.labels, merge);

  Hierarchy &hierarchy = merge.hierarchy;
  const std::size_t basins = hierarchy.roots.size();
  hierarchy.persistence.assign(basins, std::numeric_limits<float>::infinity());
  hierarchy.ancestor.assign(basins, 0);
  hierarchy.values.assign(basins, 0);
  hierarchy.by_rank.resize(basins);
  std::iota(hierarchy.by_rank.begin(), hierarchy.by_rank.end(), BasinId{0});
  hierarchy.rank = hierarchy.by_rank;
  hierarchy.background = of_label[0] != kNoBasin ? of_label[0] : most_at_the_border(merge);
  return merge;
}

} // namespace volsurf
