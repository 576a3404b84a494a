#include "volsurf/topology/field_window.h"

#include "volsurf/topology/cell_maxima.h"

#include <algorithm>
#include <limits>

namespace volsurf {

namespace {

constexpr std::int64_t kSlack = 2 * kLanes;

template <typename Ring> auto &at_plane(Ring &ring, std::int64_t z)
{
  return ring[static_cast<std::size_t>(z) % ring.size()];
}

} // namespace

FieldWindow::FieldWindow(const BorderRule &border, const RowRange &strip, const PlaneSource &source, Exterior exterior)
    : border_(border), samples_(border.samples()),
      strip_(strip), sample_rows_{std::max<std::int64_t>(strip.begin - 1, 0), std::min(strip.end + 2, samples_[1])},
      cell_rows_{sample_rows_.begin, sample_rows_.end - 1}, source_(source), stride_(samples_[0] + 1),
      order_words_(block_count(samples_[0]) * kBlockWords), newborn_words_(block_count(samples_[0]) * kNewbornWords)
{
  const float infinity = std::numeric_limits<float>::infinity();
  outside_.assign(static_cast<std::size_t>(stride_ * (strip.count() + 2) + kSlack),
                  exterior == Exterior::infinite ? infinity : -infinity);
  squares_.fill(outside_);
  cells_.fill(outside_);
  for (auto &plane : field_)
    plane.resize(static_cast<std::size_t>(samples_[0] * sample_rows_.count() + 2 * kSlack));
  for (auto &plane : order_)
    plane.resize(static_cast<std::size_t>(order_words_ * sample_rows_.count()));
  for (auto &plane : newborn_)
    plane.resize(static_cast<std::size_t>(newborn_words_ * (strip.count() + 1)));
}

void FieldWindow::advance_to(std::int64_t z)
{
  const bool starts = z != z_ + 1;
  const std::int64_t first = starts ? std::max<std::int64_t>(z - 1, 0) : z + 2;
  const std::int64_t last = std::min(z + 2, samples_[2] - 1);
  for (std::int64_t plane = first; plane <= last; ++plane) {
    const bool has_lower = plane > first || !starts;
    load(plane);
    compare(plane, has_lower);
    if (has_lower)
      make_cells(plane - 1);
  }
  if (starts)
    find_newborn_in(z);
  if (z + 1 < samples_[2])
    find_newborn_in(z + 1);
  z_ = z;
}

void FieldWindow::load(std::int64_t z)
{
  float *const plane = at_plane(field_, z).data() + kSlack;
  source_(z, sample_rows_, plane);
  CellPlane &squares = at_plane(squares_, z);
  for (std::int64_t y = cell_rows_.begin; y < cell_rows_.end; ++y) {
    const float *const row = plane + (y - sample_rows_.begin) * samples_[0];
    square_maxima(row, row + samples_[0], samples_[0], squares.data() + framed_start(y) + 1);
  }
}

/// Rows and planes that are not at hand are replaced by others: who needs the order has them.
void FieldWindow::compare(std::int64_t z, bool has_lower)
{
  const std::int64_t below = has_lower ? z - 1 : z;
  for (std::int64_t y = sample_rows_.begin; y < sample_rows_.end; ++y)
    compare_with_lower(values(y, z), {values(y - 1, z), {values(y - 1, below), values(y, below), values(y + 1, below)}},
                       samples_[0], at_plane(order_, z).data() + (y - sample_rows_.begin) * order_words_);
}

/// Makes the cells between sample planes z and z + 1. Rows are whole, frames left and right are put back.
void FieldWindow::make_cells(std::int64_t z)
{
  const CellPlane &lower = at_plane(squares_, z);
  const CellPlane &upper = at_plane(squares_, z + 1);
  CellPlane &cells = at_plane(cells_, z);
  for (std::int64_t y = cell_rows_.begin; y < cell_rows_.end; ++y) {
    const std::int64_t row = framed_start(y) + 1;
    cell_maxima(lower.data() + row, upper.data() + row, samples_[0] - 1, cells.data() + row);
  }
}

void FieldWindow::find_newborn_in(std::int64_t z)
{
  for (std::int64_t y = strip_.begin; y < std::min(strip_.end + 1, samples_[1]); ++y) {
    const StarRows rows{
        order_row(y, z), order_row(y + 1, z), {order_row(y - 1, z + 1), order_row(y, z + 1), order_row(y + 1, z + 1)}};
    find_newborn(rows, y, z, border_, at_plane(newborn_, z).data() + (y - strip_.begin) * newborn_words_);
  }
}

OrderRow FieldWindow::order_row(std::int64_t y, std::int64_t z) const
{
  const std::int64_t row = std::clamp(y, sample_rows_.begin, sample_rows_.end - 1) - sample_rows_.begin;
  return at_plane(order_, z).data() + row * order_words_;
}

const float *FieldWindow::values(std::int64_t y, std::int64_t z) const
{
  const std::int64_t row = std::clamp(y, sample_rows_.begin, sample_rows_.end - 1) - sample_rows_.begin;
  return at_plane(field_, z).data() + kSlack + row * samples_[0];
}

NewbornRow FieldWindow::newborn_row(std::int64_t y, std::int64_t z) const
{
  return at_plane(newborn_, z).data() + (y - strip_.begin) * newborn_words_;
}

const float *FieldWindow::octant_row(std::int64_t y, std::int64_t z, int i) const
{
  return framed_row(y - 1 + (i & 1), z - 1 + (i >> 1));
}

CellRows FieldWindow::cell_rows(std::int64_t y) const
{
  return {framed_row(y, z_) + 1, framed_row(y - 1, z_) + 1, framed_row(y + 1, z_) + 1, framed_row(y, z_ - 1) + 1,
          framed_row(y, z_ + 1) + 1};
}

CornerRows FieldWindow::corner_rows(std::int64_t y) const
{
  return {newborn_row(y, z_), newborn_row(y + 1, z_), newborn_row(y, z_ + 1), newborn_row(y + 1, z_ + 1)};
}

const FieldWindow::CellPlane &FieldWindow::cell_plane(std::int64_t z) const
{
  return z >= 0 && z + 1 < samples_[2] ? at_plane(cells_, z) : outside_;
}

const float *FieldWindow::framed_row(std::int64_t y, std::int64_t z) const
{
  return cell_plane(z).data() + framed_start(y);
}

} // namespace volsurf
