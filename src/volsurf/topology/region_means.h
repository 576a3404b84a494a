// What the scan is like within each region, and around it.
#pragma once

#include "volsurf/core/cell_labels.h"
#include "volsurf/core/volume.h"
#include "volsurf/topology/hierarchy.h"

namespace volsurf {

/// The mean intensity of each region, indexed by region id: over its cells, each the mean of its corners, which are the
/// volume's samples; 0 for index 0. O(cells), parallel; takes 64 bytes per region.
std::vector<double> region_means(const CellLabels &cells, const Volume &volume, const Regions &regions);

/// For each region, the mean over the faces that it shares with others of `means` on their other sides; its own where
/// it shares none. O(cells), parallel; takes 128 bytes per region.
std::vector<double> means_around(const CellLabels &cells, const Regions &regions, const std::vector<double> &means);

} // namespace volsurf
