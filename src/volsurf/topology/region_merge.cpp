#include "volsurf/topology/region_merge.h"

#include "volsurf/core/parallel.h"
#include "volsurf/topology/background.h"

namespace volsurf {

RegionMerge merge_regions(const Index3 &samples, const PlaneSource &field, const MergeOptions &options,
                          const Progress &progress)
{
  const CellGrid cells(Index3{samples[0] - 1, samples[1] - 1, samples[2] - 1});
  const TileSize tile = options.tile.value_or(default_tile_size(samples));
  StarSweep sweep = sweep_stars(samples, field, options.exterior, tile, progress);
  Basins basins = label_basins(cells, sweep, options.exterior, tile.planes);
  BasinTree tree = join_saddles(cells, basins, sweep, tile.planes);
  RegionMerge merge{{cells.size, std::move(basins.labels)}, make_hierarchy(basins, tree, options.exterior)};
  Hierarchy &hierarchy = merge.hierarchy;
  hierarchy.background = hierarchy.exterior
                             ? *hierarchy.exterior
                             : find_background(hierarchy, count_border_faces(merge.cells, hierarchy.basin_count()));
  return merge;
}

} // namespace volsurf
