#include "volsurf/surface/scan_model.h"

#include "volsurf/core/parallel.h"
#include "volsurf/surface/voxel_shares.h"

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

/// And of the one that weighs those around, which the two intensities are taken from.
constexpr double kAround = 2;

constexpr float kLeastWeight = 1e-4F; ///< of a row of voxels
constexpr int kReach = 3;             ///< voxels to both sides of the nearest
constexpr int kLanes = 8;             ///< 2 kReach + 1 and one more, whose weight is 0
constexpr double kPi = 3.14159265358979323846;

/// The scan's own samples, of a volume that may be oversampled.
PaddedRows samples_in(const Window &window, const Volume &volume)
{
  const Index3 &size = window.grid.size;
  const std::int64_t length = size[0] + 2 * PaddedRows::kPadding;
  PaddedRows rows{size, std::vector<float>(static_cast<std::size_t>(length * size[1] * size[2]))};
  const std::int64_t step = volume.grid.oversampling;
  parallel_for_slabs(size[2], 1, [&](const Slab &slab) {
    for (std::int64_t z = slab.begin; z < slab.end; ++z)
      for (std::int64_t y = 0; y < size[1]; ++y) {
        const Index3 first{step * window.begin[0], step * (window.begin[1] + y), step * (window.begin[2] + z)};
        const float *const from =
            volume.samples.data() + first[0] + volume.grid.size[0] * (first[1] + volume.grid.size[1] * first[2]);
        float *const to = rows.values.data() + (z * size[1] + y) * length + PaddedRows::kPadding;
        for (std::int64_t x = 0; x < size[0]; ++x)
          to[x] = from[step * x];
      }
  });
  return rows;
}

using Lanes = std::array<float, kLanes>;

double sum_of(const Lanes &lanes)
{
  double sum = 0;
  for (const float lane : lanes)
    sum += static_cast<double>(lane);
  return sum;
}

/// The weights of the samples around a place in a window, along an axis. Samples beyond the window and the outermost of
/// the scan, whose voxels caps cut in two, weigh nothing.
struct AxisWeights {
  AxisWeights(double place, int axis, const Window &window, double sigma)
      : first(std::clamp<std::int64_t>(std::llround(place), 0, window.grid.size[axis] - 1) - kReach)
  {
    for (int i = 0; i <= 2 * kReach; ++i) {
      const std::int64_t sample = first + i;
      const std::int64_t in_scan = window.begin[axis] + sample;
      const bool counts =
          sample >= 0 && sample < window.grid.size[axis] && in_scan > 0 && in_scan < window.of_scan[axis] - 1;
      const double distance = static_cast<double>(sample) - place;
      weights[i] = counts ? static_cast<float>(std::exp(-distance * distance / (2 * sigma * sigma))) : 0.0F;
    }
  }

  std::int64_t first;
  Lanes weights{};
};

/// Weighted sums over samples g and the parts h of their voxels that are inside: those that both means need.
struct Sums {
  Lanes w{};
  Lanes h{};
  Lanes g{};

  void add(int lane, float weight, float part, float sample)
  {
    w[lane] += weight;
    h[lane] += weight * part;
    g[lane] += weight * sample;
  }
};

/// Those that a straight line needs.
struct LineSums : Sums {
  Lanes hh{};
  Lanes hg{};
  Lanes gg{};

  void add(int lane, float weight, float part, float sample)
  {
    Sums::add(lane, weight, part, sample);
    hh[lane] += weight * part * part;
    hg[lane] += weight * part * sample;
    gg[lane] += weight * sample * sample;
  }
};

/// And those that the sd of a mean needs.
struct MeanSums : Sums {
  Lanes ww{};

  void add(int lane, float weight, float part, float sample)
  {
    Sums::add(lane, weight, part, sample);
    ww[lane] += weight * weight;
  }
};

template <typename AllSums> AllSums sums_around(const Vec3 &place, double sigma, const ScanModel &model)
{
  const AxisWeights x(place[0], 0, model.window, sigma);
  const AxisWeights y(place[1], 1, model.window, sigma);
  const AxisWeights z(place[2], 2, model.window, sigma);
  AllSums sums;
  for (int k = 0; k <= 2 * kReach; ++k)
    for (int j = 0; j <= 2 * kReach; ++j) {
      const float weight = y.weights[j] * z.weights[k];
      if (!(weight > kLeastWeight))
        continue;
      const float *const parts = model.shares.row(y.first + j, z.first + k) + x.first;
      const float *const samples = model.samples.row(y.first + j, z.first + k) + x.first;
      for (int lane = 0; lane < kLanes; ++lane)
        sums.add(lane, weight * x.weights[lane], parts[lane], samples[lane]);
    }
  return sums;
}

} // namespace

ScanModel::ScanModel(const Window &w, const Volume &volume)
    : window(w), samples(samples_in(w, volume)), shares{w.grid.size, {}}
{
}

void ScanModel::set_surface(const Mesh &mesh)
{
  shares.values = {}; // the last ones make room first
  shares.values = voxel_shares(mesh, window.grid, PaddedRows::kPadding);
}

std::optional<Contrast> contrast_around(const Vec3 &place, const ScanModel &model)
{
  constexpr double kLeastVariance = 1e-6; // of the parts
  constexpr double kLeastStep = 1e-5;     // as part of the intensities: less is rounding
  const auto sums = sums_around<LineSums>(place, kAround, model);
  const double w = sum_of(sums.w);
  if (!(w > 0))
    return std::nullopt;
  const double h = sum_of(sums.h) / w;
  const double g = sum_of(sums.g) / w;
  const double variance = sum_of(sums.hh) / w - h * h;
  if (!(variance > kLeastVariance))
    return std::nullopt;
  const double step = (sum_of(sums.hg) / w - h * g) / variance;
  if (!(std::abs(step) > kLeastStep * std::abs(g)))
    return std::nullopt;
  const double left_over = sum_of(sums.gg) / w - g * g - step * step * variance;
  return Contrast{g - step * h, step, std::sqrt(std::max(left_over, 0.0))};
}

std::optional<Mismatch> mismatch_at(const Vec3 &place, const Contrast &contrast, double noise, const ScanModel &model)
{
  const auto sums = sums_around<MeanSums>(place, kNear, model);
  const double w = sum_of(sums.w);
  if (!(w > 0))
    return std::nullopt;
  const double left_over = (sum_of(sums.g) - contrast.step * sum_of(sums.h)) / w - contrast.outside;
  // A wall that moves by one voxel changes the mean by so much; the variance of a voxel's own width is 1/12.
  const double change = contrast.step / std::sqrt(2 * kPi * (kNear * kNear + 1.0 / 12));
  const double way = left_over / change;
  if (!std::isfinite(way))
    return std::nullopt;
  const double error = noise * std::sqrt(sum_of(sums.ww)) / w / std::abs(change);
  return Mismatch{std::clamp(way, -kLongestWay, kLongestWay), std::min(error, kLargestError)};
}

} // namespace volsurf
