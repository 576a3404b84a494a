#include "volsurf/topology/region_means.h"

#include "support/fields.h"
#include "support/label_volumes.h"

#include "volsurf/core/parallel.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr RegionId kOne = 1;

struct Scene {
  LabelledCells labels;
  Volume volume;
  Regions regions;
};

Scene random_scene(Dice &dice, std::int64_t max_size)
{
  Scene scene{random_cells(dice, max_size, 5), {}, {}};
  scene.regions = regions_of(scene.labels);
  scene.volume.grid = grid_of(scene.labels.cells.size);
  for (std::int64_t i = 0; i < scene.volume.grid.sample_count(); ++i)
    scene.volume.samples.push_back(static_cast<float>(dice.between(-1000, 1000)));
  return scene;
}

/// Of all numbers that belong to a region.
class Mean {
public:
  void add(double number)
  {
    sum_ += number;
    ++count_;
  }

  bool is_of(double mean) const { return count_ == 0 || std::abs(sum_ / count_ - mean) < 1e-9; }

private:
  double sum_ = 0;
  int count_ = 0;
};

} // namespace

RC_GTEST_PROP(RegionMeans, AreThoseOfTheCornersOfTheirCells, ())
{
  Dice dice(*random_seed());
  const Scene scene = random_scene(dice, 6);
  const Index3 &n = scene.volume.grid.size;
  std::vector<Mean> expected(scene.regions.count() + 1);
  for_each_sample(scene.labels.cells.size, [&](const Index3 &p, CellId) {
    for (int corner = 0; corner < 8; ++corner) {
      const Index3 q{p[0] + (corner & 1), p[1] + (corner >> 1 & 1), p[2] + (corner >> 2)};
      expected[scene.regions.of_basin[scene.labels.at(p)]].add(
          static_cast<double>(scene.volume.samples[q[0] + n[0] * (q[1] + n[1] * q[2])]));
    }
  });
  const auto means = region_means(scene.labels.cells, scene.volume, scene.regions);
  for (std::size_t region = 0; region < expected.size(); ++region)
    RC_ASSERT(expected[region].is_of(means[region]));
}

RC_GTEST_PROP(SurroundingsOf, AreTheRegionsAcrossTheFaces, ())
{
  Dice dice(*random_seed());
  const Scene scene = random_scene(dice, 6);
  std::vector<double> means;
  for (std::size_t region = 0; region <= scene.regions.count(); ++region)
    means.push_back(static_cast<double>(dice.between(-1000, 1000)));
  std::vector<Mean> expected(means.size());
  std::vector<Mean> expected_parts(means.size());
  for_each_sample(scene.labels.cells.size, [&](const Index3 &p, CellId) {
    for (int axis = 0; axis < 3; ++axis) {
      Index3 q = p;
      if (++q[axis] == scene.labels.cells.size[axis])
        continue;
      const RegionId a = scene.regions.of_basin[scene.labels.at(p)];
      const RegionId b = scene.regions.of_basin[scene.labels.at(q)];
      if (a != b) {
        expected[a].add(means[b]);
        expected[b].add(means[a]);
        expected_parts[a].add(b == kOne ? 1 : 0);
        expected_parts[b].add(a == kOne ? 1 : 0);
      }
    }
  });
  const Surroundings around = surroundings_of(scene.labels.cells, scene.regions, means, kOne);
  for (std::size_t region = 0; region < expected.size(); ++region) {
    RC_ASSERT(expected[region].is_of(around.means[region]));
    RC_ASSERT(expected_parts[region].is_of(around.parts[region]));
  }
}

TEST(RegionMeans, AreTheSameForAnyNumberOfThreads)
{
  Dice dice(3);
  const Scene scene = random_scene(dice, 40);
  const auto means = region_means(scene.labels.cells, scene.volume, scene.regions);
  const Surroundings around = surroundings_of(scene.labels.cells, scene.regions, means, kOne);
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(region_means(scene.labels.cells, scene.volume, scene.regions), means) << threads;
    const Surroundings found = surroundings_of(scene.labels.cells, scene.regions, means, kOne);
    EXPECT_EQ(found.means, around.means) << threads;
    EXPECT_EQ(found.parts, around.parts) << threads;
  }
}
