// Laws of the single bodies and of their true surfaces.
#include "volsurf/phantom/body_phantom.h"

#include "volsurf/core/error.h"
#include "volsurf/interop/zero_surface.h"
#include "volsurf/surface/check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using namespace volsurf;

constexpr double kPi = 3.14159265358979323846;

PhantomOptions options_of(const Index3 &size, const Vec3 &spacing_mm)
{
  PhantomOptions options;
  options.size = size;
  options.spacing_mm = spacing_mm;
  options.bias = 0;
  return options;
}

/// By the samples' means alone, without the truth.
double volume_by_samples(const Phantom &phantom)
{
  double sum = 0;
  for (const float sample : phantom.volume.samples)
    sum += (static_cast<double>(sample) - kBodySurroundings) / (kBodySignal - kBodySurroundings);
  return sum * voxel_volume_mm3(phantom.volume.grid);
}

Mesh surface_of(BodyKind body, const Grid &grid)
{
  return zero_surface(sample_distance(body_distance(body, grid, 1), grid, refinement_for(body, grid)));
}

double distance_at(const SignedDistance &distance, const Point &p)
{
  return distance({p[0], p[1], p[2]});
}

/// Where a body's volume is known by a formula.
struct Known {
  BodyKind body;
  double volume_mm3;
};

std::vector<Known> known_bodies(double extent, double voxel)
{
  const auto ball = [](double radius) { return 4.0 / 3.0 * kPi * radius * radius * radius; };
  const double r = 0.2 * extent;
  const double h = voxel / 2; // of the cap that each of the two blobs shares
  return {{BodyKind::kSphere, ball(0.3 * extent)},
          {BodyKind::kTorus, 2 * kPi * kPi * 0.25 * extent * 0.01 * extent * extent},
          {BodyKind::kBlobs, 2 * (ball(r) - kPi * h * h * (3 * r - h) / 3)},
          {BodyKind::kShell, ball(0.3 * extent) - ball(0.3 * extent - 3 * voxel)}};
}

TEST(BodyPhantom, its_samples_hold_the_volume_of_the_body)
{
  for (const Vec3 &spacing : {Vec3{1, 1, 1}, Vec3{0.6, 0.6, 1.5}}) {
    const PhantomOptions options = options_of({64, 64, 64}, spacing);
    for (const Known &known : known_bodies(64 * spacing[0], spacing[0])) {
      const double volume = volume_by_samples(make_body_phantom(known.body, options));
      EXPECT_NEAR(volume / known.volume_mm3, 1, 0.002) << static_cast<int>(known.body) << " at " << spacing[2];
    }
  }
}

TEST(BodyPhantom, a_sample_is_the_mean_over_its_voxel)
{
  const PhantomOptions options = options_of({20, 20, 20}, {1, 1, 1.5});
  const Phantom phantom = make_body_phantom(BodyKind::kSphere, options);
  const Grid &grid = phantom.volume.grid;
  const SignedDistance distance = body_distance(BodyKind::kSphere, grid, 1);
  constexpr int kParts = 20;
  double largest = 0;
  for (std::int64_t i = 0; i < grid.sample_count(); ++i) {
    int inside = 0;
    for (int part = 0; part < kParts * kParts * kParts; ++part) {
      const Vec3 place{static_cast<double>(i % 20) + (part % kParts + 0.5) / kParts - 0.5,
                       static_cast<double>(i / 20 % 20) + (part / kParts % kParts + 0.5) / kParts - 0.5,
                       static_cast<double>(i / 400) + (part / (kParts * kParts) + 0.5) / kParts - 0.5};
      inside += distance(index_to_world(grid, place)) < 0 ? 1 : 0;
    }
    const double mean = 100 + 100.0 * inside / (kParts * kParts * kParts);
    largest = std::max(largest, std::abs(mean - phantom.volume.samples[static_cast<std::size_t>(i)]));
  }
  EXPECT_LT(largest, 1);
  EXPECT_GT(largest, 0);
}

TEST(BodyPhantom, the_true_surface_lies_on_the_body)
{
  const Grid grid = phantom_grid(options_of({48, 40, 44}, {1, 1, 1.2}));
  for (const BodyKind body : {BodyKind::kSphere, BodyKind::kTorus, BodyKind::kShell}) {
    const SignedDistance distance = body_distance(body, grid, 1);
    const Mesh mesh = surface_of(body, grid);
    ASSERT_GT(mesh.triangles.size(), 1000U);
    double largest = 0;
    for (const Triangle &t : mesh.triangles) {
      Point middle{};
      for (int axis = 0; axis < 3; ++axis)
        middle[axis] = (mesh.points[t[0]][axis] + mesh.points[t[1]][axis] + mesh.points[t[2]][axis]) / 3;
      for (const Point &p : {mesh.points[t[0]], middle})
        largest = std::max(largest, std::abs(distance_at(distance, p)));
    }
    EXPECT_LT(largest, 0.02) << static_cast<int>(body);
  }
}

TEST(BodyPhantom, the_true_surface_encloses_the_body_with_its_normals_outwards)
{
  const Grid grid = phantom_grid(options_of({64, 64, 64}, {1, 1, 1}));
  for (const Known &known : known_bodies(64, 1)) {
    const MeshCheck check = check_mesh(surface_of(known.body, grid));
    EXPECT_NEAR(check.volume_mm3 / known.volume_mm3, 1, 0.002) << static_cast<int>(known.body);
    EXPECT_TRUE(check.watertight);
  }
}

TEST(BodyPhantom, the_surface_of_the_cortex_is_closed_where_the_scan_cuts_the_stem_and_fits_its_samples)
{
  const PhantomOptions options = options_of({64, 64, 64}, {3.2, 3.2, 3.2});
  const Phantom phantom = make_body_phantom(BodyKind::kCortex, options);
  const SignedDistance distance = body_distance(BodyKind::kCortex, phantom.volume.grid, 1);
  const MeshCheck check = check_mesh(zero_surface(sample_distance(distance, phantom.volume.grid, 3)));
  EXPECT_TRUE(check.watertight);
  // The samples' voxels reach half a voxel further than the samples, where the stem is cut.
  const double half_slice = 0.5 * 3.2 * kPi * 7.5 * 7.5;
  EXPECT_NEAR((check.volume_mm3 + half_slice) / volume_by_samples(phantom), 1, 0.005);
}

TEST(BodyPhantom, a_ball_moved_to_the_border_is_cut_there_with_its_samples)
{
  PhantomOptions options = options_of({48, 48, 48}, {1, 1, 1});
  options.offset_mm = {23.19, 0, 0}; // the middle lies 0.31 beyond that of the samples, the last of them at 23.5
  const Phantom phantom = make_body_phantom(BodyKind::kSphere, options);
  const SignedDistance distance = body_distance(BodyKind::kSphere, phantom.volume.grid, 1, options.offset_mm);
  const MeshCheck check = check_mesh(zero_surface(sample_distance(distance, phantom.volume.grid, 3)));
  const double half_ball = 2.0 / 3.0 * kPi * 14.4 * 14.4 * 14.4;
  EXPECT_TRUE(check.watertight);
  EXPECT_NEAR(check.volume_mm3 / half_ball, 1, 0.002);
  const double half_slice = 0.5 * kPi * 14.4 * 14.4; // voxels reach half of one further than their samples
  EXPECT_NEAR(volume_by_samples(phantom) / (half_ball + half_slice), 1, 0.002);
}

TEST(BodyPhantom, the_truth_is_where_the_distance_is_negative)
{
  const Phantom phantom = make_body_phantom(BodyKind::kTorus, options_of({32, 32, 32}, {1, 1, 1}));
  for (std::size_t i = 0; i < phantom.truth.labels.size(); ++i) {
    const bool mostly_inside = phantom.volume.samples[i] > 160;
    const bool mostly_outside = phantom.volume.samples[i] < 140;
    if (mostly_inside || mostly_outside) {
      ASSERT_EQ(phantom.truth.labels[i], mostly_inside ? 1U : 0U);
    }
  }
}

TEST(BodyPhantom, refuses_unknown_names_and_bodies_outside_of_the_volume)
{
  EXPECT_THROW(parse_body("cube"), UsageError);
  EXPECT_FALSE(parse_body("head").has_value());
  EXPECT_EQ(parse_body("shell"), BodyKind::kShell);
  Grid grid = phantom_grid(options_of({8, 8, 8}, {1, 1, 1}));
  const SignedDistance nowhere = [](const Vec3 &) { return 1.0; };
  EXPECT_THROW(sample_distance(nowhere, grid, 2), UsageError);
}

} // namespace
