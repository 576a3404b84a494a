// The field around a strip of rows of the plane at hand, with the maxima over its cells.
#pragma once

#include "volsurf/core/plane_source.h"
#include "volsurf/topology/first_steps.h"
#include "volsurf/topology/newborn.h"

#include <array>
#include <vector>

namespace volsurf {

/// A ring of planes that moves up through the volume: samples of planes z - 1 to z + 2, maxima of cells of planes z - 1
/// to z + 1. Of each plane it has the rows of the strip and those around it.
///
/// Planes of maxima have a frame: one more column than there are samples and one more row than there are in the strip
/// and right after it, so that octant o of the star of sample (x, y) stands at (x + (o & 1), y + (o >> 1 & 1)). The
/// frame is what is outside the volume wherever that ends there.
class FieldWindow {
public:
  FieldWindow(const Index3 &samples, const RowRange &strip, const PlaneSource &source, Exterior exterior);

  /// Makes ready for plane z, which is the first one or follows the one before.
  void advance_to(std::int64_t z);

  /// The rows of samples around (y, z), where y is in the strip or right after it and z the plane at hand or the next
  /// one. Rows outside the volume are replaced by the nearest ones.
  StarRows star_rows(std::int64_t y, std::int64_t z) const;

  /// I of the cells of octants 2 * i and 2 * i + 1 of the samples of row y, plane z or z + 1, in the strip; octant o of
  /// sample x is at x + (o & 1).
  const float *octant_row(std::int64_t y, std::int64_t z, int i) const;

  /// The cells of row y of the cell grid, in the strip, and their neighbours.
  CellRows cell_rows(std::int64_t y) const;

private:
  struct CellPlane {
    std::vector<float> values;
    std::vector<CornerCode> corners;
  };

  void load(std::int64_t z);
  void make_cells(std::int64_t z);
  const CellPlane &cell_plane(std::int64_t z) const;
  CellRow framed_row(std::int64_t y, std::int64_t z) const;
  std::int64_t framed_start(std::int64_t y) const { return (y - strip_.begin + 1) * stride_; }

  Index3 samples_;
  RowRange strip_;
  RowRange sample_rows_; // all that the window has
  RowRange cell_rows_;   // those of them that are in the volume
  const PlaneSource &source_;
  std::int64_t stride_; // of the planes of maxima
  std::int64_t z_ = -2;
  CellPlane outside_;
  std::array<std::vector<float>, 4> field_; // a float of slack at each end, since stars read beyond their rows
  std::array<CellPlane, 2> squares_;        // maxima over 2 x 2 samples of a plane
  std::array<CellPlane, 3> cells_;
};

} // namespace volsurf
