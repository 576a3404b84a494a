// How near surfaces come to the truth, with all defaults and the automatic delta: bars that hold for other seeds, too.
#include "volsurf/pipeline/decide_delta.h"
#include "volsurf/pipeline/finishing.h"

#include "support/partial_volumes.h"

#include "volsurf/phantom/noise.h"
#include "volsurf/surface/check.h"
#include "volsurf/surface/extract.h"

#include <gtest/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr double kRadius = 18;
constexpr double kPi = 3.14159265358979;
const Vec3 kCentre{27.3, 28.1, 27.6};

double distance_to_sphere(const Vec3 &p)
{
  return std::hypot(p[0] - kCentre[0], p[1] - kCentre[1], p[2] - kCentre[2]) - kRadius;
}

/// As `volsurf --surface hull --keep 1`.
Mesh hull_of(const Volume &volume)
{
  Settings settings;
  settings.surface = SurfaceKind::hull;
  MergedVolume merged;
  merged.input.volume = volume;
  merge_input(merged);
  const EdgeField field(merged.input.volume, settings.field);
  const Hierarchy &hierarchy = merged.merge.hierarchy;
  const Regions regions = cut(hierarchy, decide_delta(settings, merged, field).delta);
  const RegionId background = regions.of_basin[hierarchy.background];
  Sides sides{regions.of_basin, 0};
  for (RegionId &side : sides.of_basin)
    side = side == background ? 0 : 1;
  FaceSet faces = find_boundary(merged.merge.cells, sides);
  const Components components = find_components(faces, volume.grid, {KeepCount{1}, RankBy::faces});
  const RegionsOfCells regions_of_cells{merged.merge.cells, regions.of_basin, background, hierarchy.background,
                                        [&](BasinId a, BasinId b) { return saliency(hierarchy, a, b); }};
  Mesh mesh = extract_mesh(keep_components(std::move(faces), components), volume.grid, sides, regions_of_cells, true);
  Finisher(merged.input.volume, field.sigma_mm(), settings).finish(mesh);
  return mesh;
}

double vertex_error(const Mesh &mesh)
{
  double squared = 0;
  for (const Point &p : mesh.points)
    squared += std::pow(distance_to_sphere({p[0], p[1], p[2]}), 2);
  return std::sqrt(squared / static_cast<double>(mesh.points.size()));
}

struct Bar {
  const char *noise;
  double voxels; ///< root mean square of the points' distance to the sphere
};

class Sphere : public testing::TestWithParam<Bar> {};

} // namespace

TEST_P(Sphere, IsFoundWithinTheBarAndHasItsVolume)
{
  const Volume clean = scan_of_body({56, 57, 58}, distance_to_sphere);
  const double true_volume = 4.0 / 3.0 * kPi * kRadius * kRadius * kRadius;
  for (const std::uint64_t seed : {1, 2, 3}) {
    Volume volume = clean;
    NoiseOptions noise = parse_noise(GetParam().noise, 100);
    noise.seed = seed;
    add_noise(volume, noise);
    const Mesh mesh = hull_of(volume);
    EXPECT_LE(vertex_error(mesh), GetParam().voxels) << seed;
    EXPECT_NEAR(signed_volume_mm3(mesh), true_volume, 0.005 * true_volume) << seed;
    EXPECT_TRUE(check_mesh(mesh).watertight) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Noise, Sphere,
                         testing::Values(Bar{"none", 0.03}, Bar{"gaussian:10%", 0.08}, Bar{"gaussian:20%", 0.12},
                                         Bar{"gaussian:40%", 0.25}, Bar{"impulse:1%", 0.05}, Bar{"impulse:5%", 0.08},
                                         Bar{"impulse:10%", 0.12}, Bar{"impulse:20%", 0.2}),
                         [](const auto &test) {
                           std::string name = test.param.noise;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });
