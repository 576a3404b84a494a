// How the merge gets its field: some rows of a plane at a time, never as a whole.
#pragma once

#include <cstdint>
#include <functional>

namespace volsurf {

/// Half-open range of rows (y) of a plane.
struct RowRange {
  std::int64_t begin;
  std::int64_t end;

  std::int64_t count() const { return end - begin; }
};

/// Writes I of some rows of sample plane z to `out`: size[0] finite floats each, x fastest. It is called from several
/// threads, more than once for some rows, and must give the same values each time.
using PlaneSource = std::function<void(std::int64_t z, const RowRange &rows, float *out)>;

} // namespace volsurf
