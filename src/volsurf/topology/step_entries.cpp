#include "volsurf/topology/step_entries.h"

#include "volsurf/core/vectorise.h"

#include <algorithm>

namespace volsurf {

namespace {

/// The entry of the cell, or cells, at x of a row.
template <typename Entries>
VOLSURF_LANES_INLINE void enter_steps_at(const EntryRow &row, std::int64_t x, const Entries &first_pointers)
{
  BasinId *const entries = row.slab + row.begin + x;
  const Entries pointers = first_pointers + static_cast<BasinId>(row.begin + x);
  const auto &lower_row = lanes_at<Entries>(entries - std::min(row.row, row.begin));
  const auto &lower_plane = lanes_at<Entries>(entries - std::min(row.plane, row.begin));
  Entries entry = lanes_at<Entries>(entries);
  const Entries step = entry - kFirstStepCode;
  entry = step == 1 ? pointers + 1 : entry;
  entry = step == 2 ? lower_row : entry;
  entry = step == 3 ? pointers + static_cast<BasinId>(row.row) : entry;
  entry = step == kToLowerPlane ? lower_plane : entry;
  entry = step == kToUpperPlane ? pointers + static_cast<BasinId>(row.plane) : entry;
  entry = step == kToExterior ? Entries{} + row.exterior : entry;
  lanes_at<Entries>(entries) = entry;
}

} // namespace

VOLSURF_VECTORISE
void enter_steps(const EntryRow &row)
{
  constexpr UInt32x8 kPlace = {0, 1, 2, 3, 4, 5, 6, 7};
  for (std::int64_t x = 0; row.row < kLanes && x < row.row; ++x)
    enter_steps_at<BasinId>(row, x, kPointerFlag);
  for (std::int64_t x = 0; row.row >= kLanes && x < row.row; x += kLanes)
    enter_steps_at<UInt32x8>(row, std::min(x, row.row - kLanes), kPlace + kPointerFlag); // entered twice is as once
}

} // namespace volsurf
