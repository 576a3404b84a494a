#include "volsurf/phantom/phantom.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"
#include "volsurf/phantom/bias_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace volsurf {

namespace {

/// Intensity of each Tissue at one height.
using TissueSignals = std::array<double, kTissueCount>;

TissueSignals signals_at(double height_mm)
{
  TissueSignals signals{};
  for (std::size_t i = 0; i < signals.size(); ++i)
    signals[i] = tissue_signal(static_cast<Tissue>(i), height_mm);
  return signals;
}

struct Mixture {
  double intensity;
  Tissue tissue;
};

/// Lays the bodies over each other from the outside inwards, each with the part of the voxel that it covers.
Mixture mix(const BodyDistances &bodies, const TissueSignals &signals, double voxel_mm)
{
  Mixture mixture{signals[0], Tissue::kAir};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double covered = std::clamp(0.5 - bodies[i] / voxel_mm, 0.0, 1.0);
    const Tissue tissue = kBodyTissues[i];
    mixture.intensity += covered * (signals[static_cast<std::size_t>(tissue)] - mixture.intensity);
    if (bodies[i] < 0)
      mixture.tissue = tissue;
  }
  return mixture;
}

/// What the samples are made from.
struct Recipe {
  FoldPattern folds;
  BiasField bias;
  double voxel_mm;
};

/// Fills the row of samples along x that `row` counts.
void fill_row(const Recipe &recipe, std::int64_t row, Phantom &phantom)
{
  const Grid &grid = phantom.volume.grid;
  Index3 index{0, row % grid.size[1], row / grid.size[1]};
  const auto point_of = [&grid](const Index3 &i) {
    return index_to_world(grid, {static_cast<double>(i[0]), static_cast<double>(i[1]), static_cast<double>(i[2])});
  };
  const TissueSignals signals = signals_at(point_of(index)[2]);
  auto sample = static_cast<std::size_t>(row * grid.size[0]);
  for (; index[0] < grid.size[0]; ++index[0], ++sample) {
    const Mixture mixture = mix(head_distances(recipe.folds, point_of(index)), signals, recipe.voxel_mm);
    phantom.volume.samples[sample] = static_cast<float>(mixture.intensity * bias_at(recipe.bias, index));
    if (!phantom.truth.labels.empty())
      phantom.truth.labels[sample] = static_cast<std::uint32_t>(mixture.tissue);
  }
}

void check_options(const PhantomOptions &options)
{
  std::int64_t room = std::numeric_limits<std::int64_t>::max() / static_cast<std::int64_t>(sizeof(float));
  for (const std::int64_t size : options.size) {
    if (size < 2)
      throw UsageError("size: " + std::to_string(size) + " samples on an axis, at least 2 are needed");
    room /= size;
  }
  if (room < 1)
    throw UsageError("size: more samples than this machine can count");
  for (const double spacing : options.spacing_mm)
    if (!(spacing > 0) || !std::isfinite(spacing))
      throw UsageError("spacing: " + std::to_string(spacing) + " mm, must be greater than 0");
  if (!(options.bias >= 0 && options.bias <= 1))
    throw UsageError("bias: " + std::to_string(options.bias) + ", must lie in 0 .. 1");
}

} // namespace

Grid phantom_grid(const PhantomOptions &options)
{
  check_options(options);
  Grid grid;
  grid.size = options.size;
  grid.spacing_mm = options.spacing_mm;
  for (int axis = 0; axis < 3; ++axis)
    grid.origin_mm[axis] = -0.5 * options.spacing_mm[axis] * static_cast<double>(options.size[axis] - 1);
  return grid;
}

double tissue_signal(Tissue tissue, double height_mm)
{
  // From the middle of the head to just above its lower end: a slope that is no wall at any delta of use.
  constexpr double kWholeMm = 30;
  constexpr double kGoneMm = -95;
  const double air = kTissueIntensity[0];
  const double whole = kTissueIntensity[static_cast<std::size_t>(tissue)];
  const double part = is_brain(tissue) ? 1 : std::clamp((height_mm - kGoneMm) / (kWholeMm - kGoneMm), 0.0, 1.0);
  return air + part * (whole - air);
}

Phantom make_head_phantom(const PhantomOptions &options, const Progress &progress)
{
  Phantom phantom;
  phantom.volume.grid = phantom.truth.grid = phantom_grid(options);
  const Grid &grid = phantom.volume.grid;
  phantom.volume.samples.resize(static_cast<std::size_t>(grid.sample_count()));
  if (options.with_truth)
    phantom.truth.labels.resize(static_cast<std::size_t>(grid.sample_count()));

  const Recipe recipe{make_fold_pattern(options.anatomy),
                      make_bias_field(grid, options.bias, options.anatomy, kHeadExtentMm),
                      std::cbrt(voxel_volume_mm3(grid))};
  const std::int64_t rows = grid.size[1] * grid.size[2];
  constexpr std::int64_t kRowsPerSlab = 16;
  parallel_for_slabs(rows, kRowsPerSlab, [&](const Slab &slab) {
    report_progress(progress, "phantom", static_cast<double>(slab.begin) / static_cast<double>(rows));
    for (std::int64_t row = slab.begin; row < slab.end; ++row)
      fill_row(recipe, row, phantom);
  });
  return phantom;
}

Vec3 spacing_that_fits_the_head(const Index3 &size)
{
  const double spacing = kHeadExtentMm / static_cast<double>(*std::min_element(size.begin(), size.end()));
  return {spacing, spacing, spacing};
}

} // namespace volsurf
