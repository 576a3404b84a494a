#include "volsurf/baseline/level_crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace volsurf {

namespace {

double mix(double a, double b, double fraction)
{
  return a + fraction * (b - a);
}

/// Calls visit(p, i) for the samples of a box, x fastest, until it returns true.
template <typename Visit> void visit_samples(const Grid &grid, const Index3 &low, const Index3 &high, Visit visit)
{
  for (std::int64_t z = low[2]; z < high[2]; ++z)
    for (std::int64_t y = low[1]; y < high[1]; ++y)
      for (std::int64_t x = low[0]; x < high[0]; ++x)
        if (visit(Index3{x, y, z}, static_cast<std::size_t>((z * grid.size[1] + y) * grid.size[0] + x)))
          return;
}

/// Where the edge from a sample to the next one along an axis crosses the value, as a fraction of the edge.
std::optional<double> crossing(const Volume &volume, double iso, std::size_t sample, std::size_t next)
{
  const double a = volume.samples[sample];
  const double b = volume.samples[next];
  if ((a >= iso) == (b >= iso) || !std::isfinite(a) || !std::isfinite(b))
    return std::nullopt;
  return (iso - a) / (b - a);
}

std::optional<Vec3> first_crossing(const Volume &volume, double iso, const Index3 &low, const Index3 &high)
{
  const Index3 &size = volume.grid.size;
  const Index3 stride{1, size[0], size[0] * size[1]};
  std::optional<Vec3> found;
  visit_samples(volume.grid, low, high, [&](const Index3 &p, std::size_t sample) {
    for (std::size_t axis = 0; axis < 3 && !found; ++axis) {
      if (p[axis] + 1 == size[axis])
        continue;
      if (const auto fraction = crossing(volume, iso, sample, sample + static_cast<std::size_t>(stride[axis]))) {
        found = Vec3{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
        (*found)[axis] += *fraction;
      }
    }
    return found.has_value();
  });
  return found;
}

} // namespace

bool reaches(const Volume &volume, double iso, const Vec3 &index)
{
  const Index3 &size = volume.grid.size;
  Index3 low{};
  Vec3 fraction{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(index[axis] >= 0 && index[axis] <= static_cast<double>(size[axis] - 1)))
      return false;
    low[axis] = std::min(static_cast<std::int64_t>(index[axis]), size[axis] - 2);
    fraction[axis] = index[axis] - static_cast<double>(low[axis]);
  }
  const float *const corner = &volume.samples[static_cast<std::size_t>((low[2] * size[1] + low[1]) * size[0] + low[0])];
  const auto along_x = [&](std::int64_t y, std::int64_t z) {
    const float *const row = corner + (z * size[1] + y) * size[0];
    return mix(row[0], row[1], fraction[0]);
  };
  const double front = mix(along_x(0, 0), along_x(1, 0), fraction[1]);
  const double back = mix(along_x(0, 1), along_x(1, 1), fraction[1]);
  return mix(front, back, fraction[2]) >= iso;
}

std::vector<Vec3> level_crossings(const Volume &volume, double iso, std::int64_t block)
{
  const Index3 &size = volume.grid.size;
  std::vector<Vec3> result;
  for (std::int64_t z = 0; z < size[2]; z += block)
    for (std::int64_t y = 0; y < size[1]; y += block)
      for (std::int64_t x = 0; x < size[0]; x += block) {
        const Index3 high{std::min(x + block, size[0]), std::min(y + block, size[1]), std::min(z + block, size[2])};
        if (const auto point = first_crossing(volume, iso, {x, y, z}, high))
          result.push_back(*point);
      }
  return result;
}

} // namespace volsurf
