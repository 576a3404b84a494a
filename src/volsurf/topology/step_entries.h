// What the steps of a row of cells lead to, as far as no other cell of the row has a part in it: the first half of the
// labelling's forward pass (basins.cpp).
//
// Entries of cells are codes of steps at first, then labels of basins or pointers to cells of the same slab.
#pragma once

#include "volsurf/topology/cubical_complex.h"

namespace volsurf {

/// Marks an entry that leads to another cell of the slab: the flag and the cell's place in the slab.
constexpr BasinId kPointerFlag = 0x80000000U;

/// The most cells of a slab, so that no pointer looks like the code of a step.
constexpr std::int64_t kMostEntries = std::int64_t{kFirstStepCode} - std::int64_t{kPointerFlag};

/// An entry that is the one of the cell to the left: step 0, which remains to be done.
constexpr BasinId kToTheLeft = step_code(0);

constexpr Step kToLowerPlane = 4;
constexpr Step kToUpperPlane = 5;

/// A row of a slab.
struct EntryRow {
  BasinId *slab;      ///< its entries
  std::int64_t begin; ///< of the row, in the slab
  std::int64_t row;   ///< cells from one row to the next, and in this row
  std::int64_t plane; ///< cells from one plane to the next
  BasinId exterior;   ///< label of the exterior's basin
};

/// Puts pointers in place of steps to later cells, and for steps to earlier rows what stands there. Labels, and steps
/// to the left, remain. Steps must not lead out of the slab. Eight cells at a time.
void enter_steps(const EntryRow &row);

} // namespace volsurf
