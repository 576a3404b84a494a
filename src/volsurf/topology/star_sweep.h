// The one pass over the samples of the field: steps A, B and C of the region merge.
//
// In: I, plane by plane. Out: for each cell the step to the neighbour with which its first face in K joins it (a tree
// edge of persistence 0), the roots of the forest that the steps make, and the saddle faces, the only ones of all other
// faces that can be edges of the tree.
//
// Guarantees: exact for Kruskal in order K; each step is written once; roots ascend by cell, saddle faces follow the
// order of their samples, and K within a star. Neither tiles nor threads can change any of it. Per tile it holds four
// planes of I, five of maxima and some bits of each sample, of a strip of rows that is narrow enough for all of them to
// stay in a core's cache.
#pragma once

#include "volsurf/core/buffer.h"
#include "volsurf/core/plane_source.h"
#include "volsurf/core/progress.h"
#include "volsurf/topology/cubical_complex.h"

#include <cstdint>
#include <vector>

namespace volsurf {

/// A face at a sample of one plane of a strip.
using FaceCode = std::uint32_t;

/// Names the faces at the samples of a strip's plane by a cell that has the sample as a corner and the step across the
/// face: cells are numbered through the two planes around the samples, as far as the strip goes.
class StripFaces {
public:
  /// Throws Error where there are 2^29 cells or more.
  StripFaces(const CellGrid &cells, const RowRange &rows, std::int64_t z);

  FaceCode code(const Index3 &sample, int octant, Step step) const
  {
    const std::int64_t row = sample[1] - rows_.begin + (octant >> 1 & 1);
    const std::int64_t cell = sample[0] - 1 + (octant & 1) + row_ * row + (octant >> 2) * cells_of_plane_;
    return static_cast<FaceCode>(cell << 3 | step);
  }

  CellId cell(FaceCode code) const
  {
    const std::int64_t cell = code >> 3;
    return first_ + cell + (cell < cells_of_plane_ ? 0 : plane_ - cells_of_plane_);
  }
  static Step step(FaceCode code) { return static_cast<Step>(code & 7U); }

private:
  RowRange rows_;
  std::int64_t row_;
  std::int64_t plane_;
  CellId first_;                ///< the cell of number 0: it may be outside the volume
  std::int64_t cells_of_plane_; ///< in the strip
};

/// A saddle face, in 8 bytes: there are many.
struct Saddle {
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
  RowRange rows;
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
