#include "volsurf/topology/region_merge.h"

namespace volsurf {

RegionMerge merge_regions(const Index3 &samples, const PlaneSource &field, const MergeOptions &options,
                          const Progress &progress)
{
  const CellGrid cells(Index3{samples[0] - 1, samples[1] - 1, samples[2] - 1});
  StarSweep sweep = sweep_stars(samples, field, options.exterior, options.planes_per_slab, progress);
  Basins basins = label_basins(cells, sweep, options.exterior, options.planes_per_slab);
  std::vector<SaddleEdge> edges = saddle_edges(cells, basins, sweep);
  return {{cells.size, std::move(basins.labels)}, make_hierarchy(basins, edges, options.exterior)};
}

} // namespace volsurf
