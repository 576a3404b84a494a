#include "volsurf/phantom/bias_field.h"

#include "volsurf/phantom/random.h"

#include <cmath>

namespace volsurf {

BiasField make_bias_field(const Grid &grid, double bias, std::uint64_t seed, double extent_mm)
{
  // Positions that make_fold_pattern, which shares the seed, does not use.
  constexpr std::uint64_t kFirstPosition = 1000;
  // Half a period or so across the body: slower than any anatomy.
  constexpr double kRadiansPerExtent = 4.096;
  BiasField field{bias / 2, {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double phase = 6.283185307179586 * random_uniform(seed, kFirstPosition + axis);
    for (std::int64_t i = 0; i < grid.size[axis]; ++i) {
      const double position = grid.origin_mm[axis] + grid.spacing_mm[axis] * static_cast<double>(i);
      field.waves[axis].push_back(std::cos(kRadiansPerExtent / extent_mm * position + phase) / 3);
    }
  }
  return field;
}

double bias_at(const BiasField &field, const Index3 &index)
{
  const auto wave = [&](std::size_t axis) { return field.waves[axis][static_cast<std::size_t>(index[axis])]; };
  return 1 + field.amplitude * (wave(0) + wave(1) + wave(2));
}

} // namespace volsurf
