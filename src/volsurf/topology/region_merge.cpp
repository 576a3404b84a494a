#include "volsurf/topology/region_merge.h"

#include "volsurf/core/parallel.h"
#include "volsurf/topology/background.h"

namespace volsurf {

RegionMerge merge_regions(const Index3 &samples, const PlaneSource &field, const MergeOptions &options,
                          const Progress &progress)
{
  const CellGrid cells(Index3{samples[0] - 1, samples[1] - 1, samples[2] - 1});
  const std::int64_t planes_per_slab = options.planes_per_slab.value_or(large_slab(samples[2]));
  StarSweep sweep = sweep_stars(samples, field, options.exterior, planes_per_slab, progress);
  Basins basins = label_basins(cells, sweep, options.exterior, planes_per_slab);
  std::vector<SaddleEdge> edges = saddle_edges(cells, basins, sweep);
  RegionMerge merge{{cells.size, std::move(basins.labels)}, make_hierarchy(basins, edges, options.exterior)};
  Hierarchy &hierarchy = merge.hierarchy;
  hierarchy.background = hierarchy.exterior
                             ? *hierarchy.exterior
                             : find_background(hierarchy, count_border_faces(merge.cells, hierarchy.basin_count()));
  return merge;
}

} // namespace volsurf
