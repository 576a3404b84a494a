#include "volsurf/field/facing_walls.h"

#include "volsurf/core/parallel.h"
#include "volsurf/field/gaussian_blur.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace volsurf {

namespace {

constexpr double kSteepest = 1e-3;  ///< the part of the samples that tells how steep the strongest walls are
constexpr float kWall = 0.25F;      ///< as steep in comparison
constexpr double kNoiseOnWalls = 5; ///< and by so many sd of noise
constexpr float kAcross = 0.7F;     ///< the part of a slope that is along the axis which leads across a wall
constexpr float kFacing = 0.5F;     ///< as steep as the wall that it faces
constexpr std::int64_t kSamplesAcross = 2;

/// The sd that noise of sd 1 has in a slope along an axis, after a Gaussian of one voxel: of two samples that are two
/// apart half the difference, along the others the mean.
double noise_in_slope()
{
  constexpr double kPi = 3.14159265358979323846;
  const double mean = 1 / (2 * std::sqrt(kPi));
  return std::sqrt(mean * (1 - std::exp(-1.0)) / 2) * mean;
}

/// The slopes of samples from one to the next, at those that have room for them on all sides.
struct Slopes {
  Slopes(const Index3 &n, std::vector<float> blurred)
      : size(n), strides{1, n[0], n[0] * n[1]}, samples(std::move(blurred))
  {
  }

  float along(int axis, std::int64_t sample) const
  {
    return (samples[static_cast<std::size_t>(sample + strides[axis])] -
            samples[static_cast<std::size_t>(sample - strides[axis])]) /
           2;
  }

  float steepness(std::int64_t sample) const
  {
    return std::hypot(along(0, sample), along(1, sample), along(2, sample));
  }

  /// Whether the slope at a sample, as steep as that, has one that faces it.
  bool is_faced(const Index3 &index, std::int64_t sample, float steep) const
  {
    for (int axis = 0; axis < 3; ++axis) {
      const float slope = along(axis, sample);
      if (!(std::abs(slope) >= kAcross * steep))
        continue;
      for (const std::int64_t step : {-kSamplesAcross, kSamplesAcross}) {
        const std::int64_t there = index[axis] + step;
        if (there < 1 || there > size[axis] - 2)
          continue;
        const float other = along(axis, sample + step * strides[axis]);
        if (slope * other < 0 && std::abs(other) > kFacing * std::abs(slope))
          return true;
      }
    }
    return false;
  }

  /// Calls visit(index, sample) for the samples of a plane that have neighbours on all sides.
  template <typename Visit> void for_each_inner(std::int64_t z, const Visit &visit) const
  {
    for (std::int64_t y = 1; y + 1 < size[1]; ++y)
      for (std::int64_t x = 1; x + 1 < size[0]; ++x)
        visit(Index3{x, y, z}, x + strides[1] * y + strides[2] * z);
  }

  Index3 size;
  Index3 strides;
  std::vector<float> samples;
};

/// The least steepness of a wall.
float least_steepness(std::vector<float> steepness, double noise)
{
  const auto strongest = static_cast<std::ptrdiff_t>(kSteepest * static_cast<double>(steepness.size()));
  std::nth_element(steepness.begin(), steepness.begin() + strongest, steepness.end(), std::greater<>());
  const auto above_noise = static_cast<float>(kNoiseOnWalls * noise * noise_in_slope());
  return std::max(kWall * steepness[static_cast<std::size_t>(strongest)], above_noise);
}

} // namespace

double part_of_facing_walls(const Volume &volume, double noise)
{
  const Index3 &size = volume.grid.size;
  if (*std::min_element(size.begin(), size.end()) < 3)
    return 0;
  const Slopes slopes(size, gaussian_blur(volume, Vec3{1, 1, 1}));
  std::vector<float> steepness(slopes.samples.size());
  parallel_for_slabs(size[2] - 2, 1, [&](const Slab &slab) {
    slopes.for_each_inner(slab.begin + 1, [&](const Index3 &, std::int64_t sample) {
      steepness[static_cast<std::size_t>(sample)] = slopes.steepness(sample);
    });
  });
  const float least = least_steepness(steepness, noise);

  std::vector<std::int64_t> on_walls(static_cast<std::size_t>(size[2]));
  std::vector<std::int64_t> faced(on_walls.size());
  parallel_for_slabs(size[2] - 2, 1, [&](const Slab &slab) {
    const auto plane = static_cast<std::size_t>(slab.begin + 1);
    slopes.for_each_inner(slab.begin + 1, [&](const Index3 &index, std::int64_t sample) {
      const float steep = steepness[static_cast<std::size_t>(sample)];
      if (!(steep > least))
        return;
      ++on_walls[plane];
      faced[plane] += slopes.is_faced(index, sample, steep) ? 1 : 0;
    });
  });
  const auto walls = std::accumulate(on_walls.begin(), on_walls.end(), std::int64_t{0});
  const auto facing = std::accumulate(faced.begin(), faced.end(), std::int64_t{0});
  return walls > 0 ? static_cast<double>(facing) / static_cast<double>(walls) : 0;
}

} // namespace volsurf
