// The one pass over the samples of the field: steps A, B and C of the region merge.
//
// In: I, plane by plane. Out: for each cell the step to the neighbour with which its first face in K joins it (a tree
// edge of persistence 0), the roots of the forest that the steps make, and the saddle faces, the only ones of all other
// faces that can be edges of the tree.
//
// Guarantees: exact for Kruskal in order K; each step is written once; roots ascend by cell, saddle faces follow the
// order of their samples, and K within a star. Neither tiles nor threads can change any of it. Per tile it holds four
// planes of I and five of maxima, of a strip of rows that is narrow enough for all of them to stay in a core's cache.
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

/// A saddle face, in 12 bytes: there are many.
struct __attribute__((packed, aligned(4))) Saddle {
  FaceCode face;
  float value; ///< its I
};

/// The cell without a step that stands for its basin.
struct Root {
  CellId cell;
  float value; ///< its I
};

/// The work of a thread: a strip of rows in some planes.
struct TileSize {
  std::int64_t planes;
  std::int64_t rows;
};

/// What one strip of rows contributes.
struct StripStars {
  std::vector<std::vector<Root>> roots;     ///< per plane of cells
  std::vector<std::vector<Saddle>> saddles; ///< per plane of samples
};

struct StarSweep {
  Buffer<BasinId> codes;          ///< step_code() of each cell
  std::vector<StripStars> strips; ///< in ascending order
};

/// Tiles of these volumes that suit the caches and the threads.
TileSize default_tile_size(const Index3 &samples);

/// Sweeps the stars of all samples, in parallel over tiles. O(samples).
StarSweep sweep_stars(const Index3 &samples, const PlaneSource &field, Exterior exterior, const TileSize &tile,
                      const Progress &progress);

} // namespace volsurf
