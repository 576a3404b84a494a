#include "volsurf/field/noise_level.h"

#include "volsurf/core/parallel.h"
#include "volsurf/field/oversample.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

constexpr std::int64_t kMostSamples = std::int64_t{1} << 20;

/// The median of |x| for normal x of standard deviation 1.
constexpr double kNormalMedian = 0.6744897501960817;

/// Weights 1, -2, 1 along an axis of the scan; along one that is too short for them a lone 1.
struct SecondDifference {
  explicit SecondDifference(std::int64_t samples) : wide(samples >= 3), positions(wide ? samples - 2 : samples) {}

  double weight(int k) const { return !wide || k != 1 ? 1.0 : -2.0; }
  int taps() const { return wide ? 3 : 1; }
  double norm() const { return wide ? std::sqrt(6.0) : 1.0; }

  bool wide;
  std::int64_t positions; ///< where the weights fit
};

/// The rows of a volume that are looked at: every `step`-th of those where the differences along y and z fit.
struct Rows {
  Rows(const Volume &v) : Rows(v, scan_grid(v.grid).size) {}

  Rows(const Volume &v, const Index3 &scan_size)
      : volume(v), x(scan_size[0]), y(scan_size[1]), z(scan_size[2]),
        step(1 + y.positions * z.positions * x.positions / kMostSamples),
        count((y.positions * z.positions + step - 1) / step)
  {
  }

  /// The differences at the samples of a row, over the norm of their weights.
  void differences(std::int64_t row, float *out) const
  {
    const std::int64_t first_y = row * step % y.positions;
    const std::int64_t first_z = row * step / y.positions;
    const double norm = x.norm() * y.norm() * z.norm();
    for (std::int64_t i = 0; i < x.positions; ++i) {
      double sum = 0;
      for (int c = 0; c < z.taps(); ++c)
        for (int b = 0; b < y.taps(); ++b)
          for (int a = 0; a < x.taps(); ++a)
            sum += x.weight(a) * y.weight(b) * z.weight(c) * sample(i + a, first_y + b, first_z + c);
      out[i] = static_cast<float>(std::abs(sum) / norm);
    }
  }

  /// One of the scan's own: what lies between them has less noise.
  double sample(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const auto &[nx, ny, nz] = volume.grid.size;
    const std::int64_t index = volume.grid.oversampling * (i + nx * (j + ny * k));
    return static_cast<double>(volume.samples[static_cast<std::size_t>(index)]);
  }

  const Volume &volume;
  SecondDifference x;
  SecondDifference y;
  SecondDifference z;
  std::int64_t step;
  std::int64_t count;
};

} // namespace

double measure_sample_noise(const Volume &volume)
{
  const Rows rows(volume);
  std::vector<float> values(static_cast<std::size_t>(rows.count * rows.x.positions));
  parallel_for_slabs(rows.count, 64, [&](const Slab &slab) {
    for (std::int64_t row = slab.begin; row < slab.end; ++row)
      rows.differences(row, values.data() + row * rows.x.positions);
  });
  values.erase(std::remove(values.begin(), values.end(), 0.0F), values.end());
  if (values.empty())
    return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return static_cast<double>(*middle) / kNormalMedian;
}

NoiseLevel measure_noise(const Volume &volume, const EdgeField &field)
{
  const double deviation = measure_sample_noise(volume);
  return {deviation, deviation * field.noise_gain()};
}

} // namespace volsurf
