// What the scan is like within each region, and around it.
#pragma once

#include "volsurf/core/cell_labels.h"
#include "volsurf/core/volume.h"
#include "volsurf/topology/hierarchy.h"

namespace volsurf {

/// The mean intensity of each region, indexed by region id: over its cells, each the mean of its corners, which are the
/// volume's samples; 0 for index 0. O(cells), parallel; takes 64 bytes per region.
std::vector<double> region_means(const CellLabels &cells, const Volume &volume, const Regions &regions);

/// What lies across the faces that a region shares with others, per region id.
struct Surroundings {
  std::vector<double> means; ///< of `means` over those faces; its own where it shares none
  std::vector<double> parts; ///< of those faces, that are shared with one region
};

/// `parts` are those with `one`. O(cells), parallel; takes 192 bytes per region.
Surroundings surroundings_of(const CellLabels &cells, const Regions &regions, const std::vector<double> &means,
                             RegionId one);

} // namespace volsurf
