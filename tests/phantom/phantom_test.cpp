// Laws of the head phantom and of its noise.
#include "volsurf/phantom/phantom.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"
#include "volsurf/field/gradient.h"
#include "volsurf/phantom/noise.h"
#include "volsurf/phantom/random.h"
#include "volsurf/topology/region_merge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace {

using namespace volsurf;

PhantomOptions small_options(std::int64_t size = 64)
{
  PhantomOptions options;
  options.size = {size, size, size};
  options.spacing_mm = spacing_that_fits_the_head(options.size);
  return options;
}

/// The phantom at the resolution of data/brain.nrrd, without bias, shared because it takes a second to make.
const Phantom &standard_phantom()
{
  static const Phantom phantom = [] {
    PhantomOptions options;
    options.bias = 0;
    return make_head_phantom(options);
  }();
  return phantom;
}

Volume constant_volume(float value)
{
  Volume volume;
  volume.grid.size = {100, 100, 100};
  volume.samples.assign(1000000, value);
  return volume;
}

Volume ramp_volume()
{
  Volume volume = constant_volume(0);
  for (std::size_t i = 0; i < volume.samples.size(); ++i)
    volume.samples[i] = static_cast<float>(i % 1000);
  return volume;
}

double mean(const std::vector<float> &values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double standard_deviation(const std::vector<float> &values)
{
  const double middle = mean(values);
  double sum = 0;
  for (const float value : values)
    sum += (value - middle) * (value - middle);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

Tissue tissue_at(const LabelVolume &truth, std::int64_t x, std::int64_t y, std::int64_t z)
{
  const Index3 &size = truth.grid.size;
  return static_cast<Tissue>(truth.labels[static_cast<std::size_t>((z * size[1] + y) * size[0] + x)]);
}

/// Calls visit(tissue, neighbour's tissue) for each pair of samples that share a grid edge, in both orders.
template <typename Visit> void for_each_contact(const LabelVolume &truth, const Visit &visit)
{
  const Index3 &size = truth.grid.size;
  for (std::int64_t z = 0; z < size[2]; ++z)
    for (std::int64_t y = 0; y < size[1]; ++y)
      for (std::int64_t x = 0; x < size[0]; ++x) {
        const Tissue here = tissue_at(truth, x, y, z);
        for (int axis = 0; axis < 3; ++axis) {
          Index3 next{x, y, z};
          if (++next[axis] == size[axis])
            continue;
          const Tissue there = tissue_at(truth, next[0], next[1], next[2]);
          visit(here, there);
          visit(there, here);
        }
      }
}

/// The region that holds most of each tissue, in the field at sigma one voxel; a cell counts for the tissue at its
/// lowest corner.
struct MainRegions {
  std::array<RegionId, kTissueCount> of_tissue;
  std::size_t count; ///< of all regions

  RegionId of(Tissue tissue) const { return of_tissue[static_cast<std::size_t>(tissue)]; }
};

MainRegions main_regions(const Phantom &phantom, double delta)
{
  const EdgeField field(phantom.volume, {});
  const RegionMerge merge = merge_regions(phantom.volume.grid.size, field.planes(), {});
  const Regions regions = cut(merge.hierarchy, delta);
  std::array<std::map<RegionId, std::int64_t>, kTissueCount> cells;
  const Index3 &size = merge.cells.size;
  std::size_t cell = 0;
  for (std::int64_t z = 0; z < size[2]; ++z)
    for (std::int64_t y = 0; y < size[1]; ++y)
      for (std::int64_t x = 0; x < size[0]; ++x, ++cell)
        ++cells[static_cast<std::size_t>(tissue_at(phantom.truth, x, y, z))]
               [regions.of_basin[merge.cells.basins[cell]]];
  MainRegions main{{}, regions.count()};
  for (std::size_t i = 0; i < cells.size(); ++i)
    main.of_tissue[i] = std::max_element(cells[i].begin(), cells[i].end(), [](const auto &a, const auto &b) {
                          return a.second < b.second;
                        })->first;
  return main;
}

/// Up to this delta two points, in mm, are in different regions.
double largest_delta_between(const Phantom &phantom, const Vec3 &a, const Vec3 &b)
{
  const Grid &grid = phantom.volume.grid;
  const EdgeField field(phantom.volume, {});
  const RegionMerge merge = merge_regions(grid.size, field.planes(), {});
  const auto basin_at = [&](const Vec3 &point) {
    std::int64_t cell = 0;
    for (const int axis : {2, 1, 0}) {
      const double index = (point[axis] - grid.origin_mm[axis]) / grid.spacing_mm[axis];
      cell = cell * merge.cells.size[axis] + static_cast<std::int64_t>(index);
    }
    return merge.cells.basins[static_cast<std::size_t>(cell)];
  };
  return saliency(merge.hierarchy, basin_at(a), basin_at(b));
}

void expect_the_brain_alone_to_stand_out(const Phantom &phantom, double delta)
{
  const MainRegions main = main_regions(phantom, delta);
  const RegionId air = main.of(Tissue::kAir);
  for (const Tissue outside : {Tissue::kScalp, Tissue::kSkull, Tissue::kCsf, Tissue::kMuscle})
    EXPECT_EQ(main.of(outside), air) << "tissue " << static_cast<int>(outside) << " at delta " << delta;
  EXPECT_NE(main.of(Tissue::kWhite), air) << "at delta " << delta;
  EXPECT_EQ(main.of(Tissue::kGrey), main.of(Tissue::kWhite)) << "at delta " << delta;
  EXPECT_NE(main.of(Tissue::kVentricle), air) << "at delta " << delta;
}

TEST(Random, is_the_published_splitmix64)
{
  // First outputs for state 1234567, as the generator's authors give them.
  EXPECT_EQ(splitmix64_mix(1234567 + 0x9e3779b97f4a7c15ULL), 6457827717110365317ULL);
  EXPECT_EQ(splitmix64_mix(1234567 + 2 * 0x9e3779b97f4a7c15ULL), 3203168211198807973ULL);
}

TEST(Random, uniform_numbers_fill_the_unit_interval)
{
  double sum = 0;
  double square = 0;
  constexpr int kCount = 100000;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const double u = random_uniform(7, i);
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
    square += u * u;
  }
  EXPECT_NEAR(sum / kCount, 0.5, 0.004);
  EXPECT_NEAR(square / kCount, 1.0 / 3, 0.004);
}

TEST(HeadPhantom, same_options_make_the_same_samples_for_any_number_of_threads)
{
  const Phantom all = make_head_phantom(small_options());
  const ThreadLimit one(1);
  const Phantom serial = make_head_phantom(small_options());
  EXPECT_EQ(all.volume.samples, serial.volume.samples);
  EXPECT_EQ(all.truth.labels, serial.truth.labels);
}

TEST(HeadPhantom, another_anatomy_folds_otherwise_and_keeps_the_skull)
{
  PhantomOptions options = small_options();
  options.bias = 0;
  const Phantom first = make_head_phantom(options);
  options.anatomy = 2;
  const Phantom second = make_head_phantom(options);
  EXPECT_NE(first.truth.labels, second.truth.labels);
  for (std::size_t i = 0; i < first.truth.labels.size(); ++i) {
    const auto a = static_cast<Tissue>(first.truth.labels[i]);
    const auto b = static_cast<Tissue>(second.truth.labels[i]);
    if (a != b) {
      EXPECT_TRUE(is_brain(a) || a == Tissue::kCsf);
      EXPECT_TRUE(is_brain(b) || b == Tissue::kCsf);
    }
  }
}

TEST(HeadPhantom, truth_is_left_out_on_request)
{
  PhantomOptions options = small_options(32);
  options.with_truth = false;
  const Phantom phantom = make_head_phantom(options);
  EXPECT_TRUE(phantom.truth.labels.empty());
  options.with_truth = true;
  EXPECT_EQ(phantom.volume.samples, make_head_phantom(options).volume.samples);
}

TEST(HeadPhantom, is_centred_in_the_world_whatever_its_shape)
{
  PhantomOptions options;
  options.size = {20, 30, 40};
  options.spacing_mm = {9, 7, 5};
  const Grid grid = make_head_phantom(options).volume.grid;
  EXPECT_EQ(grid.size, options.size);
  const Vec3 middle = index_to_world(grid, {9.5, 14.5, 19.5});
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(middle[axis], 0, 1e-12);
}

TEST(HeadPhantom, tissues_have_the_volumes_of_a_head)
{
  std::array<double, kTissueCount> litres{};
  const Phantom &phantom = standard_phantom();
  for (const std::uint32_t label : phantom.truth.labels) {
    ASSERT_LT(label, static_cast<std::uint32_t>(kTissueCount));
    litres[label] += voxel_volume_mm3(phantom.truth.grid) * 1e-6;
  }
  const auto of = [&](Tissue tissue) { return litres[static_cast<std::size_t>(tissue)]; };
  EXPECT_GT(of(Tissue::kScalp), 0.2);
  EXPECT_GT(of(Tissue::kSkull), 0.2);
  EXPECT_GT(of(Tissue::kCsf), 0.1);
  EXPECT_GT(of(Tissue::kGrey), 0.3);
  EXPECT_GT(of(Tissue::kWhite), 0.3);
  EXPECT_GT(of(Tissue::kVentricle), 0.01);
  EXPECT_GT(of(Tissue::kMuscle), 0.1);
  EXPECT_NEAR(of(Tissue::kGrey) + of(Tissue::kWhite), 1.2, 0.3);
}

TEST(HeadPhantom, shells_nest_so_that_dark_fluid_and_bone_part_the_brain_from_the_rest)
{
  std::array<std::set<Tissue>, kTissueCount> neighbours;
  for_each_contact(standard_phantom().truth,
                   [&](Tissue here, Tissue there) { neighbours[static_cast<std::size_t>(here)].insert(there); });
  const auto of = [&](Tissue tissue) { return neighbours[static_cast<std::size_t>(tissue)]; };
  using Set = std::set<Tissue>;
  EXPECT_EQ(of(Tissue::kAir), (Set{Tissue::kAir, Tissue::kScalp}));
  EXPECT_EQ(of(Tissue::kSkull), (Set{Tissue::kScalp, Tissue::kSkull, Tissue::kCsf, Tissue::kMuscle}));
  EXPECT_EQ(of(Tissue::kCsf).count(Tissue::kScalp), 0U);
  EXPECT_EQ(of(Tissue::kCsf).count(Tissue::kMuscle), 0U);
  for (const Tissue brain : {Tissue::kGrey, Tissue::kWhite, Tissue::kVentricle})
    for (const Tissue outside : {Tissue::kAir, Tissue::kScalp, Tissue::kSkull, Tissue::kMuscle})
      EXPECT_EQ(of(brain).count(outside), 0U);
}

TEST(HeadPhantom, at_least_three_voxels_part_the_brain_from_what_is_bright_outside)
{
  const LabelVolume &truth = standard_phantom().truth;
  const Index3 &size = truth.grid.size;
  constexpr std::int64_t kGap = 3;
  for (std::int64_t z = kGap; z < size[2] - kGap; ++z)
    for (std::int64_t y = kGap; y < size[1] - kGap; ++y)
      for (std::int64_t x = kGap; x < size[0] - kGap; ++x) {
        if (!is_brain(tissue_at(truth, x, y, z)))
          continue;
        for (std::int64_t dz = -kGap; dz <= kGap; ++dz)
          for (std::int64_t dy = -kGap; dy <= kGap; ++dy)
            for (std::int64_t dx = -kGap; dx <= kGap; ++dx) {
              const Tissue near = tissue_at(truth, x + dx, y + dy, z + dz);
              ASSERT_TRUE(is_brain(near) || near == Tissue::kCsf || near == Tissue::kSkull)
                  << "at " << x << ' ' << y << ' ' << z;
            }
      }
}

TEST(HeadPhantom, grey_matter_covers_white_matter_except_at_stem_and_callosum)
{
  std::int64_t white_to_grey = 0;
  std::int64_t white_to_fluid = 0;
  for_each_contact(standard_phantom().truth, [&](Tissue here, Tissue there) {
    white_to_grey += here == Tissue::kWhite && there == Tissue::kGrey;
    white_to_fluid += here == Tissue::kWhite && there == Tissue::kCsf;
  });
  EXPECT_GT(white_to_fluid, 0);
  EXPECT_LT(static_cast<double>(white_to_fluid), 0.1 * static_cast<double>(white_to_grey));
}

TEST(HeadPhantom, ventricles_lie_within_the_brain)
{
  std::int64_t to_brain = 0;
  std::int64_t to_fluid = 0;
  for_each_contact(standard_phantom().truth, [&](Tissue here, Tissue there) {
    to_brain += here == Tissue::kVentricle && there != Tissue::kVentricle && is_brain(there);
    to_fluid += here == Tissue::kVentricle && there == Tissue::kCsf;
  });
  EXPECT_LT(static_cast<double>(to_fluid), 0.02 * static_cast<double>(to_brain));
}

TEST(HeadPhantom, the_stem_and_the_neck_leave_through_the_bottom_only)
{
  const LabelVolume &truth = standard_phantom().truth;
  const std::int64_t last = truth.grid.size[0] - 1;
  std::set<Tissue> bottom;
  for (std::int64_t a = 0; a <= last; ++a)
    for (std::int64_t b = 0; b <= last; ++b) {
      bottom.insert(tissue_at(truth, a, b, 0));
      EXPECT_EQ(tissue_at(truth, a, b, last), Tissue::kAir);
      EXPECT_EQ(tissue_at(truth, 0, a, b), Tissue::kAir);
      EXPECT_EQ(tissue_at(truth, last, a, b), Tissue::kAir);
      EXPECT_EQ(tissue_at(truth, a, 0, b), Tissue::kAir);
      EXPECT_EQ(tissue_at(truth, a, last, b), Tissue::kAir);
    }
  EXPECT_EQ(bottom, (std::set<Tissue>{Tissue::kAir, Tissue::kScalp, Tissue::kSkull, Tissue::kCsf, Tissue::kWhite,
                                      Tissue::kMuscle}));
}

TEST(HeadPhantom, samples_are_pure_inside_tissues_and_mixed_at_walls)
{
  const Phantom &phantom = standard_phantom();
  const Grid &grid = phantom.volume.grid;
  const auto [darkest, brightest] = std::minmax_element(kTissueIntensity.begin(), kTissueIntensity.end());
  const auto plane = static_cast<std::size_t>(grid.size[0] * grid.size[1]);
  std::int64_t mixed = 0;
  for (std::size_t i = 0; i < phantom.volume.samples.size(); ++i) {
    const float intensity = phantom.volume.samples[i];
    ASSERT_GE(intensity, *darkest);
    ASSERT_LE(intensity, *brightest);
    const double height_mm = index_to_world(grid, {0, 0, static_cast<double>(i / plane)})[2];
    const auto tissue = static_cast<Tissue>(phantom.truth.labels[i]);
    mixed += intensity != static_cast<float>(tissue_signal(tissue, height_mm));
  }
  EXPECT_GT(mixed, phantom.volume.grid.sample_count() / 50);
  EXPECT_LT(mixed, phantom.volume.grid.sample_count() / 3);
}

TEST(HeadPhantom, signal_around_the_brain_fades_slowly_to_that_of_air)
{
  constexpr double kTopMm = kHeadExtentMm / 2;
  for (std::size_t i = 0; i < kTissueIntensity.size(); ++i) {
    const auto tissue = static_cast<Tissue>(i);
    EXPECT_EQ(tissue_signal(tissue, kTopMm), kTissueIntensity[i]);
    EXPECT_EQ(tissue_signal(tissue, -kTopMm), kTissueIntensity[is_brain(tissue) ? i : 0]);
    for (double z = -kTopMm; z < kTopMm; z += 1) {
      const double rise = tissue_signal(tissue, z + 1) - tissue_signal(tissue, z);
      EXPECT_GE(rise, 0);
      EXPECT_LE(rise, 8);
    }
  }
}

TEST(HeadPhantom, all_but_the_brain_leaks_into_the_air_at_delta_20)
{
  for (const std::uint64_t anatomy : {1U, 2U, 3U}) {
    PhantomOptions options = small_options();
    options.anatomy = anatomy;
    expect_the_brain_alone_to_stand_out(make_head_phantom(options), 20);
  }
}

TEST(HeadPhantom, at_128_samples_the_brain_stands_out_for_a_wide_range_of_delta)
{
  // Paths from the scalp to the air stay below 18 per mm, and none from the brain to the air below 40.
  expect_the_brain_alone_to_stand_out(standard_phantom(), 18);
  expect_the_brain_alone_to_stand_out(standard_phantom(), 40);
}

TEST(HeadPhantom, impulses_as_in_the_example_scan_do_not_change_that)
{
  Phantom phantom = make_head_phantom({});
  add_noise(phantom.volume, {NoiseKind::kImpulse, 0.02, 1});
  expect_the_brain_alone_to_stand_out(phantom, 20);
  EXPECT_LT(main_regions(phantom, 20).count, 100U);
}

TEST(HeadPhantom, grey_and_white_matter_part_at_a_smaller_delta_than_brain_and_air)
{
  const Vec3 deep_grey{25, -8, 11};
  const Vec3 white{35, 0, 30};
  const double parted_up_to = largest_delta_between(standard_phantom(), deep_grey, white);
  EXPECT_GT(parted_up_to, 15);
  EXPECT_LT(parted_up_to, 25);
  EXPECT_GT(largest_delta_between(standard_phantom(), {0, 26, -100}, {-100, -100, 100}), 40) << "stem and air";
}

TEST(HeadPhantom, making_one_can_be_stopped)
{
  const auto stop_half_way = [](std::string_view, double fraction) { return fraction < 0.5; };
  EXPECT_THROW(make_head_phantom(small_options(16), stop_half_way), Cancelled);
}

TEST(HeadPhantom, the_skin_lies_at_the_half_way_intensity)
{
  // Between air and scalp, the outermost wall, no third tissue mixes in.
  const Phantom &phantom = standard_phantom();
  const float half = (kTissueIntensity[0] + kTissueIntensity[1]) / 2;
  for (std::size_t i = 0; i < phantom.volume.samples.size(); ++i)
    if (static_cast<Tissue>(phantom.truth.labels[i]) == Tissue::kAir) {
      ASSERT_LE(phantom.volume.samples[i], half);
    }
}

TEST(HeadPhantom, bias_is_a_smooth_factor_within_its_limits)
{
  PhantomOptions options = small_options();
  options.bias = 0;
  const Phantom flat = make_head_phantom(options);
  options.bias = 0.4;
  const Phantom biased = make_head_phantom(options);
  EXPECT_EQ(flat.truth.labels, biased.truth.labels);
  double smallest = 2;
  double largest = 0;
  double last = 0;
  for (std::size_t i = 0; i < flat.volume.samples.size(); ++i) {
    const double factor = biased.volume.samples[i] / static_cast<double>(flat.volume.samples[i]);
    smallest = std::min(smallest, factor);
    largest = std::max(largest, factor);
    if (i % 64 != 0) { // not across the ends of rows
      ASSERT_LT(std::abs(factor - last), 0.01);
    }
    last = factor;
  }
  EXPECT_GE(smallest, 0.8 - 1e-6);
  EXPECT_LE(largest, 1.2 + 1e-6);
  EXPECT_GT(largest - smallest, 0.1);
}

TEST(HeadPhantom, refuses_options_out_of_range)
{
  const auto with = [](auto &&change) {
    PhantomOptions options = small_options(8);
    change(options);
    return options;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(make_head_phantom(with([](auto &o) { o.size[1] = 1; })), UsageError);
  EXPECT_THROW(make_head_phantom(with([](auto &o) { o.size.fill(std::int64_t{1} << 40); })), UsageError);
  EXPECT_THROW(make_head_phantom(with([](auto &o) { o.spacing_mm[2] = 0; })), UsageError);
  EXPECT_THROW(make_head_phantom(with([=](auto &o) { o.spacing_mm[0] = nan; })), UsageError);
  EXPECT_THROW(make_head_phantom(with([](auto &o) { o.bias = 1.1; })), UsageError);
  EXPECT_THROW(make_head_phantom(with([=](auto &o) { o.bias = nan; })), UsageError);
}

TEST(Noise, depends_on_its_seed_alone)
{
  for (const NoiseKind kind : {NoiseKind::kImpulse, NoiseKind::kGaussian, NoiseKind::kRician}) {
    Volume first = ramp_volume();
    Volume again = ramp_volume();
    Volume other = ramp_volume();
    add_noise(first, {kind, 0.5, 1});
    {
      const ThreadLimit one(1);
      add_noise(again, {kind, 0.5, 1});
    }
    add_noise(other, {kind, 0.5, 2});
    EXPECT_EQ(first.samples, again.samples);
    EXPECT_NE(first.samples, other.samples);
  }
}

TEST(Noise, impulses_replace_the_stated_fraction_by_values_uniform_over_the_range)
{
  const Volume clean = ramp_volume();
  Volume noisy = clean;
  constexpr double kFraction = 0.02;
  add_noise(noisy, {NoiseKind::kImpulse, kFraction, 5});
  std::vector<float> impulses;
  for (std::size_t i = 0; i < clean.samples.size(); ++i)
    if (noisy.samples[i] != clean.samples[i])
      impulses.push_back(noisy.samples[i]);
  const double count = static_cast<double>(clean.samples.size());
  const double five_sigma = 5 * std::sqrt(count * kFraction * (1 - kFraction));
  EXPECT_NEAR(static_cast<double>(impulses.size()), count * kFraction, five_sigma);
  EXPECT_GE(*std::min_element(impulses.begin(), impulses.end()), 0);
  EXPECT_LE(*std::max_element(impulses.begin(), impulses.end()), 999);
  EXPECT_NEAR(mean(impulses), 499.5, 10);
  EXPECT_NEAR(standard_deviation(impulses), 999 / std::sqrt(12.0), 6);
}

TEST(Noise, gaussian_has_the_stated_deviation_no_mean_and_normal_tails)
{
  Volume volume = constant_volume(1000);
  add_noise(volume, {NoiseKind::kGaussian, 30, 3});
  EXPECT_NEAR(mean(volume.samples), 1000, 5 * 30 / 1000.0);
  EXPECT_NEAR(standard_deviation(volume.samples), 30, 0.12);
  const auto beyond = [&](double sigmas) {
    return static_cast<double>(std::count_if(volume.samples.begin(), volume.samples.end(),
                                             [&](float v) { return std::abs(v - 1000) > sigmas * 30; }));
  };
  EXPECT_NEAR(beyond(1), 317311, 2400);
  EXPECT_NEAR(beyond(3), 2700, 260);
}

TEST(Noise, gaussian_samples_of_neighbours_are_independent)
{
  Volume volume = constant_volume(0);
  add_noise(volume, {NoiseKind::kGaussian, 1, 3});
  double product = 0;
  for (std::size_t i = 1; i < volume.samples.size(); ++i)
    product += static_cast<double>(volume.samples[i]) * static_cast<double>(volume.samples[i - 1]);
  EXPECT_NEAR(product / static_cast<double>(volume.samples.size()), 0, 0.005);
}

TEST(Noise, rician_without_signal_is_a_rayleigh_distribution)
{
  Volume volume = constant_volume(0);
  add_noise(volume, {NoiseKind::kRician, 20, 9});
  EXPECT_GE(*std::min_element(volume.samples.begin(), volume.samples.end()), 0);
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(mean(volume.samples), 20 * std::sqrt(pi / 2), 0.07);
  EXPECT_NEAR(standard_deviation(volume.samples), 20 * std::sqrt(2 - pi / 2), 0.06);
}

TEST(Noise, rician_keeps_the_second_moment_of_signal_and_noise)
{
  Volume volume = constant_volume(50);
  add_noise(volume, {NoiseKind::kRician, 20, 9});
  double square = 0;
  for (const float value : volume.samples)
    square += static_cast<double>(value) * value;
  EXPECT_NEAR(square / static_cast<double>(volume.samples.size()), 50 * 50 + 2 * 20 * 20, 12);
}

TEST(Noise, none_and_zero_change_nothing)
{
  const Volume clean = ramp_volume();
  for (const NoiseKind kind : {NoiseKind::kNone, NoiseKind::kImpulse, NoiseKind::kGaussian, NoiseKind::kRician}) {
    Volume volume = clean;
    add_noise(volume, {kind, 0, 1});
    EXPECT_EQ(volume.samples, clean.samples);
  }
}

TEST(Noise, refuses_amounts_out_of_range)
{
  Volume volume = constant_volume(1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(add_noise(volume, {NoiseKind::kImpulse, 1.01, 1}), UsageError);
  EXPECT_THROW(add_noise(volume, {NoiseKind::kImpulse, -0.1, 1}), UsageError);
  EXPECT_THROW(add_noise(volume, {NoiseKind::kGaussian, -1, 1}), UsageError);
  EXPECT_THROW(add_noise(volume, {NoiseKind::kRician, nan, 1}), UsageError);
}

TEST(ParseNoise, reads_kinds_fractions_percentages_and_intensities)
{
  const auto expect = [](const char *text, NoiseKind kind, double amount) {
    const NoiseOptions options = parse_noise(text, 1280);
    EXPECT_EQ(options.kind, kind) << text;
    EXPECT_DOUBLE_EQ(options.amount, amount) << text;
  };
  expect("none", NoiseKind::kNone, 0);
  expect("impulse:2%", NoiseKind::kImpulse, 0.02);
  expect("impulse:0.02", NoiseKind::kImpulse, 0.02);
  expect("gaussian:5%", NoiseKind::kGaussian, 64);
  expect("rician:40", NoiseKind::kRician, 40);
}

TEST(ParseNoise, refuses_everything_else)
{
  for (const char *text :
       {"", "impulse", "impulse:", "impulse:%", "impulse:2", "impulse:101%", "gaussian:-1", "gaussian:5 %",
        "gaussian:nan", "gaussian:inf", "rician:5%%", "rician:1e999", "salt:2%", "none:1", ":5%", "Impulse:2%"})
    EXPECT_THROW(parse_noise(text, 1280), UsageError) << text;
}

} // namespace
