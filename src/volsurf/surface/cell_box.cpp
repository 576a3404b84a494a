#include "volsurf/surface/cell_box.h"

#include "volsurf/core/parallel.h"

#include <algorithm>
#include <limits>

namespace volsurf {

namespace {

constexpr std::int64_t kPlanesPerSlab = 16;

CellBox nowhere()
{
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
  return {{kFar, kFar, kFar}, {0, 0, 0}};
}

void add_cells(const Index3 &low, const Index3 &high, CellBox &box)
{
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::min(box.low[axis], low[axis]);
    box.high[axis] = std::max(box.high[axis], high[axis]);
  }
}

/// Adds the cells of planes z_begin .. z_end-1, run by run, to the boxes of their regions.
void add_planes(const CellLabels &cells, const std::vector<std::uint32_t> &box_of_basin, const Slab &planes,
                std::vector<CellBox> &boxes)
{
  const auto &[nx, ny, nz] = cells.size;
  for (std::int64_t z = planes.begin; z < planes.end; ++z)
    for (std::int64_t y = 0; y < ny; ++y) {
      const BasinId *const row = cells.basins.data() + (z * ny + y) * nx;
      for (std::int64_t x = 0, begin = 0; x < nx; begin = x) {
        const std::uint32_t box = box_of_basin[row[begin]];
        while (x < nx && box_of_basin[row[x]] == box)
          ++x;
        if (box < boxes.size())
          add_cells({begin, y, z}, {x, y + 1, z + 1}, boxes[box]);
      }
    }
}

} // namespace

std::vector<CellBox> boxes_around(const CellLabels &cells, const std::vector<RegionId> &region_of_basin,
                                  const std::vector<RegionId> &wanted)
{
  std::vector<std::uint32_t> box_of_basin(region_of_basin.size());
  std::transform(region_of_basin.begin(), region_of_basin.end(), box_of_basin.begin(), [&](RegionId region) {
    const auto found = std::lower_bound(wanted.begin(), wanted.end(), region);
    const bool is_wanted = found != wanted.end() && *found == region;
    return static_cast<std::uint32_t>((is_wanted ? found : wanted.end()) - wanted.begin());
  });

  const std::int64_t slabs = slab_count(cells.size[2], kPlanesPerSlab);
  std::vector<std::vector<CellBox>> of_slab(static_cast<std::size_t>(slabs));
  parallel_for_slabs(cells.size[2], kPlanesPerSlab, [&](const Slab &slab) {
    auto &boxes = of_slab[static_cast<std::size_t>(slab.index)];
    boxes.assign(wanted.size(), nowhere());
    add_planes(cells, box_of_basin, slab, boxes);
  });

  std::vector<CellBox> boxes(wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    CellBox box = nowhere();
    for (const auto &slab : of_slab)
      add_cells(slab[i].low, slab[i].high, box);
    if (box.high[0] == 0)
      continue;
    for (int axis = 0; axis < 3; ++axis) {
      boxes[i].low[axis] = std::max<std::int64_t>(box.low[axis] - 1, 0);
      boxes[i].high[axis] = std::min(box.high[axis] + 1, cells.size[axis]);
    }
  }
  return boxes;
}

CellLabels cells_in(const CellBox &box, const CellLabels &cells)
{
  const Index3 size = box.size();
  CellLabels result{size, Buffer<BasinId>(size[0] * size[1] * size[2])};
  BasinId *out = result.basins.data();
  for (std::int64_t z = box.low[2]; z < box.high[2]; ++z)
    for (std::int64_t y = box.low[1]; y < box.high[1]; ++y, out += size[0])
      std::copy_n(cells.basins.data() + (z * cells.size[1] + y) * cells.size[0] + box.low[0], size[0], out);
  return result;
}

Grid grid_in(const CellBox &box, const Grid &grid)
{
  Grid result = grid;
  const Index3 cells = box.size();
  result.size = {cells[0] + 1, cells[1] + 1, cells[2] + 1};
  result.origin_mm = index_to_world(
      grid, {static_cast<double>(box.low[0]), static_cast<double>(box.low[1]), static_cast<double>(box.low[2])});
  return result;
}

} // namespace volsurf
