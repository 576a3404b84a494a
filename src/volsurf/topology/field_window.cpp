#include "volsurf/topology/field_window.h"

#include <algorithm>
#include <limits>

namespace volsurf {

namespace {

template <typename Ring> auto &at_plane(Ring &ring, std::int64_t z)
{
  return ring[static_cast<std::size_t>(z) % ring.size()];
}

} // namespace

FieldWindow::FieldWindow(const Index3 &samples, const RowRange &strip, const PlaneSource &source, Exterior exterior)
    : samples_(samples),
      strip_(strip), sample_rows_{std::max<std::int64_t>(strip.begin - 1, 0), std::min(strip.end + 2, samples[1])},
      cell_rows_{sample_rows_.begin, sample_rows_.end - 1}, source_(source), stride_(samples[0] + 1)
{
  const auto framed_size = static_cast<std::size_t>(stride_ * (strip.count() + 2));
  const float infinity = std::numeric_limits<float>::infinity();
  outside_.values.assign(framed_size, exterior == Exterior::infinite ? infinity : -infinity);
  outside_.corners.assign(framed_size, kNoCorner);
  squares_.fill(outside_);
  cells_.fill(outside_);
  for (auto &plane : field_)
    plane.resize(static_cast<std::size_t>(samples[0] * sample_rows_.count() + 2));
}

void FieldWindow::advance_to(std::int64_t z)
{
  const bool starts = z != z_ + 1;
  const std::int64_t first = starts ? std::max<std::int64_t>(z - 1, 0) : z + 2;
  const std::int64_t last = std::min(z + 2, samples_[2] - 1);
  for (std::int64_t plane = first; plane <= last; ++plane) {
    load(plane);
    if (plane > first || !starts)
      make_cells(plane - 1);
  }
  z_ = z;
}

void FieldWindow::load(std::int64_t z)
{
  float *const plane = at_plane(field_, z).data() + 1;
  source_(z, sample_rows_, plane);
  CellPlane &squares = at_plane(squares_, z);
  for (std::int64_t y = cell_rows_.begin; y < cell_rows_.end; ++y) {
    const float *const row = plane + (y - sample_rows_.begin) * samples_[0];
    const std::int64_t out = framed_start(y) + 1;
    square_maxima(row, row + samples_[0], samples_[0], squares.values.data() + out, squares.corners.data() + out);
  }
}

/// Makes the cells between sample planes z and z + 1. Rows are whole, frames left and right are put back.
void FieldWindow::make_cells(std::int64_t z)
{
  const CellPlane &lower = at_plane(squares_, z);
  const CellPlane &upper = at_plane(squares_, z + 1);
  CellPlane &cells = at_plane(cells_, z);
  for (std::int64_t y = cell_rows_.begin; y < cell_rows_.end; ++y) {
    const std::int64_t row = framed_start(y) + 1;
    cell_maxima(lower.values.data() + row, lower.corners.data() + row, upper.values.data() + row,
                upper.corners.data() + row, samples_[0] - 1, cells.values.data() + row, cells.corners.data() + row);
  }
}

StarRows FieldWindow::star_rows(std::int64_t y, std::int64_t z) const
{
  StarRows rows{};
  for (std::int64_t i = 0; i < 9; ++i) {
    const std::int64_t row = std::clamp<std::int64_t>(y + i % 3 - 1, 0, samples_[1] - 1) - sample_rows_.begin;
    const std::int64_t plane = std::clamp<std::int64_t>(z + i / 3 - 1, 0, samples_[2] - 1);
    rows[static_cast<std::size_t>(i)] = at_plane(field_, plane).data() + 1 + row * samples_[0];
  }
  return rows;
}

const float *FieldWindow::octant_row(std::int64_t y, std::int64_t z, int i) const
{
  return framed_row(y - 1 + (i & 1), z - 1 + (i >> 1)).values;
}

CellRows FieldWindow::cell_rows(std::int64_t y) const
{
  const auto shifted = [](CellRow row) { return CellRow{row.values + 1, row.corners + 1}; };
  return {shifted(framed_row(y, z_)), shifted(framed_row(y - 1, z_)), shifted(framed_row(y + 1, z_)),
          shifted(framed_row(y, z_ - 1)), shifted(framed_row(y, z_ + 1))};
}

const FieldWindow::CellPlane &FieldWindow::cell_plane(std::int64_t z) const
{
  return z >= 0 && z + 1 < samples_[2] ? at_plane(cells_, z) : outside_;
}

CellRow FieldWindow::framed_row(std::int64_t y, std::int64_t z) const
{
  const CellPlane &plane = cell_plane(z);
  return {plane.values.data() + framed_start(y), plane.corners.data() + framed_start(y)};
}

} // namespace volsurf
