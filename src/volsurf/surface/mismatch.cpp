#include "volsurf/surface/mismatch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace volsurf {

namespace {

constexpr double kLongestWay = 1;   ///< in voxels
constexpr double kLargestError = 3; ///< in voxels: so little a point counts at least

/// Sd in voxels of the Gaussian that weighs the voxels next to a point, whose mismatch moves it: the least that takes
/// in all that a wall there crosses. Wider ones let in more noise (0.8: 2 to 10 % more distance on the study's shapes).
constexpr double kNear = 0.6;

constexpr float kLeastWeight = 1e-3F; ///< of a row of voxels
constexpr int kReach = 2;             ///< voxels to both sides of the nearest
constexpr int kLanes = 8;             ///< 2 kReach + 1 and more, whose weights are 0
constexpr double kPi = 3.14159265358979323846;

using Lanes = std::array<float, kLanes>;

double sum_of(const Lanes &lanes)
{
  double sum = 0;
  for (const float lane : lanes)
    sum += static_cast<double>(lane);
  return sum;
}

/// The weights of the samples around a place, along an axis. Those beyond the window weigh nothing, nor do those that
/// do not count.
struct AxisWeights {
  AxisWeights(double place, int axis, const Window &window)
      : first(std::clamp<std::int64_t>(std::llround(place), 0, window.grid.size[axis] - 1) - kReach)
  {
    for (int i = 0; i <= 2 * kReach; ++i) {
      const std::int64_t sample = first + i;
      const bool counts = sample >= window.first_that_counts(axis) && sample < window.end_of_those_that_count(axis);
      const double distance = static_cast<double>(sample) - place;
      weights[i] = counts ? static_cast<float>(std::exp(-distance * distance / (2 * kNear * kNear))) : 0.0F;
    }
  }

  std::int64_t first;
  Lanes weights{};
};

/// Weighted sums over samples, of what they have more or less than the surface says.
struct Sums {
  Lanes w{};
  Lanes ww{};
  Lanes left_over{};
};

Sums sums_around(const Vec3 &place, const Contrast &contrast, double largest, const ScanModel &model)
{
  const auto outside = static_cast<float>(contrast.outside);
  const auto step = static_cast<float>(contrast.step);
  const auto change = static_cast<float>(contrast.beyond);
  const auto limit = static_cast<float>(largest);
  const AxisWeights x(place[0], 0, model.window);
  const AxisWeights y(place[1], 1, model.window);
  const AxisWeights z(place[2], 2, model.window);
  Sums sums;
  for (int k = 0; k <= 2 * kReach; ++k)
    for (int j = 0; j <= 2 * kReach; ++j) {
      const float weight = y.weights[j] * z.weights[k];
      if (!(weight > kLeastWeight))
        continue;
      const float *const shares = model.shares.row(y.first + j, z.first + k) + x.first;
      const float *const beyond = model.beyond_shares.row(y.first + j, z.first + k) + x.first;
      const float *const samples = model.samples.row(y.first + j, z.first + k) + x.first;
      for (int lane = 0; lane < kLanes; ++lane) {
        const float w = weight * x.weights[lane];
        sums.w[lane] += w;
        sums.ww[lane] += w * w;
        const float left_over = samples[lane] - (outside + step * shares[lane] + change * beyond[lane]);
        sums.left_over[lane] += w * std::min(std::max(left_over, -limit), limit);
      }
    }
  return sums;
}

} // namespace

std::optional<Mismatch> mismatch_at(const Vec3 &place, const Contrast &contrast, const Doubt &doubt,
                                    const ScanModel &model)
{
  const Sums sums = sums_around(place, contrast, doubt.limit, model);
  const double w = sum_of(sums.w);
  if (!(w > 0))
    return std::nullopt;
  // A wall that moves by one voxel changes the mean by so much; the variance of a voxel's own width is 1/12.
  const double change = contrast.step / std::sqrt(2 * kPi * (kNear * kNear + 1.0 / 12));
  const double way = sum_of(sums.left_over) / w / change;
  if (!std::isfinite(way))
    return std::nullopt;
  const double error = doubt.noise * std::sqrt(sum_of(sums.ww)) / w / std::abs(change);
  return Mismatch{std::clamp(way, -kLongestWay, kLongestWay), std::min(error, kLargestError)};
}

} // namespace volsurf
