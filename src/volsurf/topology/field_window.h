// The field around a strip of rows of the plane at hand, with the maxima over its cells.
#pragma once

#include "volsurf/core/plane_source.h"
#include "volsurf/topology/first_steps.h"

#include <array>
#include <vector>

namespace volsurf {

/// A ring of planes that moves up through the volume: samples of planes z - 1 to z + 2, what is newborn at those of
/// planes z and z + 1, maxima of cells of planes z - 1 to z + 1. Of each plane it has the rows of the strip and those
/// around it.
///
/// Planes of maxima have a frame: one more column than there are samples and one more row than there are in the strip
/// and right after it, so that octant o of the star of sample (x, y) stands at (x + (o & 1), y + (o >> 1 & 1)). The
/// frame is what is outside the volume wherever that ends there.
class FieldWindow {
public:
  FieldWindow(const BorderRule &border, const RowRange &strip, const PlaneSource &source, Exterior exterior);

  /// Makes ready for plane z, which is the first one or follows the one before.
  void advance_to(std::int64_t z);

  /// I of row (y, z), where y is in the strip or right after it and z the plane at hand or the next one.
  const float *values(std::int64_t y, std::int64_t z) const;

  /// What is newborn at the samples of that row.
  NewbornRow newborn_row(std::int64_t y, std::int64_t z) const;

  /// I of the cells of octants 2 * i and 2 * i + 1 of the samples of row y, plane z or z + 1, in the strip; octant o of
  /// sample x is at x + (o & 1).
  const float *octant_row(std::int64_t y, std::int64_t z, int i) const;

  /// The cells next to those of row y of the cell grid, in the strip and the plane at hand, and what is newborn at the
  /// row's corners.
  CellRows cell_rows(std::int64_t y) const;
  CornerRows corner_rows(std::int64_t y) const;

private:
  using CellPlane = std::vector<float>;

  void load(std::int64_t z);
  void compare(std::int64_t z, bool has_lower);
  void make_cells(std::int64_t z);
  void find_newborn_in(std::int64_t z);
  OrderRow order_row(std::int64_t y, std::int64_t z) const;
  const CellPlane &cell_plane(std::int64_t z) const;
  const float *framed_row(std::int64_t y, std::int64_t z) const;
  std::int64_t framed_start(std::int64_t y) const { return (y - strip_.begin + 1) * stride_; }

  const BorderRule &border_;
  Index3 samples_;
  RowRange strip_;
  RowRange sample_rows_; // all that the window has
  RowRange cell_rows_;   // those of them that are in the volume
  const PlaneSource &source_;
  std::int64_t stride_; // of the planes of maxima
  std::int64_t z_ = -2;
  CellPlane outside_;
  std::int64_t order_words_; // of a row
  std::int64_t newborn_words_;
  std::array<std::vector<float>, 4> field_; // with slack at each end, since comparisons read beyond their rows
  std::array<std::vector<std::uint32_t>, 3> order_;
  std::array<std::vector<std::uint32_t>, 2> newborn_;
  std::array<CellPlane, 2> squares_; // maxima over 2 x 2 samples of a plane
  std::array<CellPlane, 3> cells_;
};

} // namespace volsurf
