// Cells in random regions, and the meshes of their boundaries.
#pragma once

#include "support/fields.h"

#include "volsurf/surface/extract.h"
#include "volsurf/topology/hierarchy.h"

#include <numeric>
#include <utility>

namespace volsurf::support {

/// Basins that are regions themselves: basin b is region b + 1.
struct LabelledCells {
  CellLabels cells;
  std::vector<RegionId> region_of_basin;

  BasinId at(const Index3 &p) const { return cells.basins[p[0] + cells.size[0] * (p[1] + cells.size[1] * p[2])]; }
};

template <typename LabelAt> LabelledCells label_cells(const Index3 &size, BasinId basins, LabelAt label_at)
{
  LabelledCells result{{size, Buffer<BasinId>(size[0] * size[1] * size[2])}, std::vector<RegionId>(basins)};
  for_each_sample(size, [&](const Index3 &p, CellId cell) { result.cells.basins[cell] = label_at(p); });
  std::iota(result.region_of_basin.begin(), result.region_of_basin.end(), RegionId{1});
  return result;
}

/// The same as a cut of a hierarchy tells, but for the maxima, which are no basins of it.
inline Regions regions_of(const LabelledCells &labels)
{
  Regions regions;
  regions.of_basin = labels.region_of_basin;
  regions.maxima.resize(labels.region_of_basin.size());
  regions.cell_counts.resize(labels.region_of_basin.size());
  for (const BasinId basin : labels.cells.basins)
    ++regions.cell_counts[labels.region_of_basin[basin] - 1];
  return regions;
}

/// 1 .. max_size cells per axis, in 1 .. max_basins basins of noise or of blocks.
inline LabelledCells random_cells(Dice &dice, std::int64_t max_size, BasinId max_basins)
{
  const Index3 size{dice.between(1, max_size), dice.between(1, max_size), dice.between(1, max_size)};
  const auto basins = static_cast<BasinId>(dice.between(1, max_basins));
  const bool in_blocks = dice.one_in(3);
  const std::int64_t rarity = dice.between(1, 4); // how rare basins other than 0 are
  LabelledCells result = label_cells(size, basins, [&](const Index3 &) {
    return dice.one_in(rarity) ? static_cast<BasinId>(dice.between(0, basins - 1)) : 0;
  });
  if (in_blocks)
    for_each_sample(size, [&](const Index3 &p, CellId cell) {
      result.cells.basins[cell] = result.at({p[0] & ~1, p[1] & ~1, p[2] & ~1});
    });
  return result;
}

/// Each region for itself, within region 1.
inline Sides all_sides(const LabelledCells &labels)
{
  return {labels.region_of_basin, 1};
}

/// Every region but number 1 against it: its hull from within.
inline Sides hull_sides(const LabelledCells &labels)
{
  Sides sides{labels.region_of_basin, 0};
  for (RegionId &side : sides.of_basin)
    side = side == 1 ? 0 : 1;
  return sides;
}

/// The mesh of all faces. A face's saliency is the larger basin plus a half.
inline Mesh mesh_of(const LabelledCells &labels, const Grid &grid, const Sides &sides, bool manifold)
{
  FaceSet faces = find_boundary(labels.cells, sides);
  const Components components = find_components(faces, grid, {});
  const RegionsOfCells regions{labels.cells, labels.region_of_basin, 1, 0,
                               [](BasinId a, BasinId b) { return static_cast<float>(std::max(a, b)) + 0.5F; }};
  return extract_mesh(keep_components(std::move(faces), components), grid, sides, regions, manifold);
}

inline Grid grid_of(const Index3 &cells)
{
  Grid grid;
  grid.size = {cells[0] + 1, cells[1] + 1, cells[2] + 1};
  return grid;
}

} // namespace volsurf::support
