// The slow change of brightness over a scan that a coil leaves.
#pragma once

#include "volsurf/core/grid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace volsurf {

/// A smooth factor around 1: one slow wave along each axis, tabulated, and their sum.
struct BiasField {
  double amplitude;
  std::array<std::vector<double>, 3> waves;
};

/// Of 1 - bias/2 to 1 + bias/2, bias in 0 .. 1, over about half a period across `extent_mm`; the seed places the waves.
BiasField make_bias_field(const Grid &grid, double bias, std::uint64_t seed, double extent_mm);

double bias_at(const BiasField &field, const Index3 &index);

} // namespace volsurf
