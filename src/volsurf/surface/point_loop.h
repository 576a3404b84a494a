// A loop over the points of a mesh, on all threads.
#pragma once

#include "volsurf/core/parallel.h"

#include <cstddef>

namespace volsurf {

/// Points are done in slabs of so many, whatever the number of threads.
constexpr std::int64_t kPointsPerSlab = 4096;

/// Calls work(point) for 0 .. points - 1, each once.
template <typename Work> void for_each_point(std::size_t points, Work work)
{
  parallel_for_slabs(static_cast<std::int64_t>(points), kPointsPerSlab, [&](const Slab &slab) {
    for (std::int64_t point = slab.begin; point < slab.end; ++point)
      work(static_cast<std::size_t>(point));
  });
}

} // namespace volsurf
