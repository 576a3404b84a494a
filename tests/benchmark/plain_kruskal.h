// The region merge as it is written down: all inner faces sorted by K, then two union-finds (docs/method.md, exterior
// none).
//
// The oracle of the tests does the same with no thought of time. This one is what a good programmer would write in its
// place: reserved arrays, 32-bit ids, cells computed from faces, path halving, and only the leading keys of K (the max
// vertex: I, then index) in the sort; a vertex has 12 newborn faces at most, whose order by the rest of K is made when
// its turn comes. One thread.
#pragma once

#include "volsurf/core/grid.h"

#include <cstdint>
#include <vector>

namespace volsurf::bench {

struct PlainRegions {
  std::size_t count;
  std::vector<std::uint32_t> of_cell; ///< one of the region's cells, the same for all of them
};

/// The regions at delta of a field I with at most 2^32 / 3 samples; O(faces log faces), 52 bytes per sample.
PlainRegions plain_kruskal(const Index3 &samples, const std::vector<float> &field, float delta);

} // namespace volsurf::bench
