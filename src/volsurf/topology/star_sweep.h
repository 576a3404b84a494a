// The one pass over the samples of the field: steps A, B and C of the region merge.
//
// In: I, plane by plane. Out: for each cell the step to the neighbour with which its first face in K joins it (a tree
// edge of persistence 0), the roots of the forest that the steps make, and the saddle faces, the only ones of all other
// faces that can be edges of the tree.
//
// Guarantees: exact for Kruskal in order K; each step is written once; roots ascend by cell, saddle faces follow the
// order of their samples, and K within a star. Neither slabs nor threads can change any of it. Per slab it holds four
// planes of I and five of maxima.
#pragma once

#include "volsurf/core/buffer.h"
#include "volsurf/core/plane_source.h"
#include "volsurf/core/progress.h"
#include "volsurf/topology/cubical_complex.h"

#include <cstdint>
#include <vector>

namespace volsurf {

/// A face named by one of its cells and the step across it, 8 * cell + step.
using FaceCode = std::uint64_t;

/// The cell without a step that stands for its basin.
struct Root {
  CellId cell;
  float value; ///< its I
};

/// What one slab of samples contributes.
struct SlabStars {
  std::vector<Root> roots;
  std::vector<FaceCode> saddles;
  std::vector<float> saddle_values; ///< I of each saddle face
};

struct StarSweep {
  Buffer<BasinId> codes;        ///< step_code() of each cell
  std::vector<SlabStars> slabs; ///< in ascending order
};

/// Sweeps the stars of all samples, in parallel over slabs of `planes_per_slab` planes. O(samples).
StarSweep sweep_stars(const Index3 &samples, const PlaneSource &field, Exterior exterior, std::int64_t planes_per_slab,
                      const Progress &progress);

} // namespace volsurf
