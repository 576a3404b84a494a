// Basins, the trees of steps, and the saddle edges between them: steps D and E of the region merge.
//
// In: the steps and saddle faces of a sweep. Out: the basin of each cell, and the graph that is left when basins are
// contracted: far smaller than the dual graph (0.006 to 0.19 edges per sample on real volumes).
//
// Guarantees: basins are numbered by root cell; edges keep the order K of their faces among equal values. Passes: each
// slab of cells turns its steps into labels, in one pass forward and one backward; the paths that left it are joined up
// over the slabs; then their cells are relabelled.
#pragma once

#include "volsurf/topology/star_sweep.h"

namespace volsurf {

struct Basins {
  Buffer<BasinId> labels;                ///< per cell
  std::vector<CellId> roots;             ///< per basin, ascending; the exterior's basin, if any, is the last and has -1
  std::vector<float> values;             ///< I of the root, +infinity for the exterior
  std::vector<std::int64_t> cell_counts; ///< per basin
};

/// A saddle face, seen as an edge between two basins.
struct SaddleEdge {
  float value; ///< I of the face
  BasinId a;
  BasinId b;
};

/// Takes the sweep's codes, which become the labels, and its roots. O(cells). Throws Error where there are more than
/// 2^31 basins.
Basins label_basins(const CellGrid &cells, StarSweep &sweep, Exterior exterior, std::int64_t planes_per_slab);

/// The saddle faces between different basins, in the order of the sweep. Empties the sweep's saddles.
std::vector<SaddleEdge> saddle_edges(const CellGrid &cells, const Basins &basins, StarSweep &sweep);

} // namespace volsurf
