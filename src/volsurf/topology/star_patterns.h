// The samples of a row at which more than the steps of its cells is decided: what remains of step C of the region
// merge.
//
// In: what is newborn at the row's samples, as bits. Out: the few samples that matter, each with its pattern, which is
// put together for those only; all else is done on 256 samples at a time, without branches.
#pragma once

#include "volsurf/topology/newborn.h"

#include <vector>

namespace volsurf {

/// A sample of a row and its completed pattern.
struct StarPattern {
  std::int64_t x;
  NewbornMask mask;
  std::uint32_t real_cells; ///< octants that are cells of the volume
};

/// Some samples of a row, ascending.
struct PatternList {
  explicit PatternList(std::int64_t row_size) : found(static_cast<std::size_t>(row_size) + 1) {}

  const StarPattern *begin() const { return found.data(); }
  const StarPattern *end() const { return begin() + count; }

  std::vector<StarPattern> found; ///< with room for one more
  std::ptrdiff_t count = 0;
};

/// Finds the samples of row (y, z) that have deep octants (star_tables.h), and those at which two or more parts meet
/// that reach outside.
void find_patterns(NewbornRow newborn, std::int64_t y, std::int64_t z, const BorderRule &border, PatternList &deep,
                   PatternList &meeting);

} // namespace volsurf
