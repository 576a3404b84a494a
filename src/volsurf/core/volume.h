// A scalar volume in memory.
#pragma once

#include "volsurf/core/grid.h"

#include <cstdint>
#include <vector>

namespace volsurf {

/// One float32 per sample, x fastest. Every scalar pixel type is read into it; integers above 2^24 are rounded.
struct Volume {
  Grid grid;
  std::vector<float> samples;
};

/// One label per sample of `grid`, x fastest; 0 stands for nothing.
struct LabelVolume {
  Grid grid;
  std::vector<std::uint32_t> labels;
};

} // namespace volsurf
