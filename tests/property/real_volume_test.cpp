// Crops of the volumes that scripts/fetch_data.sh gets, against the oracle. VOLSURF_DATA names their folder; without it
// the folder is real-data in the build folder, and where there is none the tests are skipped.
#include "support/fields.h"
#include "support/merge_of_field.h"

#include "volsurf/field/gradient.h"
#include "volsurf/io/read_volume.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr std::int64_t kCropSize = 64;

std::filesystem::path data_folder()
{
  const char *const named = std::getenv("VOLSURF_DATA");
  return named != nullptr ? named : VOLSURF_REAL_DATA;
}

/// The 64^3 samples in the middle.
Volume middle_of(const Volume &volume)
{
  Volume result{volume.grid, {}};
  Index3 begin{};
  for (int axis = 0; axis < 3; ++axis) {
    result.grid.size[axis] = std::min(kCropSize, volume.grid.size[axis]);
    begin[axis] = (volume.grid.size[axis] - result.grid.size[axis]) / 2;
  }
  for_each_sample(result.grid.size, [&](const Index3 &p, SampleId) {
    const auto &[nx, ny, nz] = volume.grid.size;
    result.samples.push_back(
        volume.samples[static_cast<std::size_t>(((p[2] + begin[2]) * ny + p[1] + begin[1]) * nx + p[0] + begin[0])]);
  });
  return result;
}

Field field_of(const Volume &volume, const FieldOptions &options)
{
  const EdgeField edges(volume, options);
  Field field{volume.grid.size, std::vector<float>(volume.samples.size())};
  for (std::int64_t z = 0; z < field.size[2]; ++z)
    edges.plane(z, field.values.data() + z * field.size[0] * field.size[1]);
  return field;
}

/// Five deltas: the least, three quantiles of the persistences, and the largest persistence.
std::vector<float> five_deltas(const std::multiset<float> &persistences)
{
  std::vector<float> deltas{std::numeric_limits<float>::denorm_min()};
  const std::vector<float> sorted(persistences.begin(), persistences.end());
  if (!sorted.empty())
    for (const double quantile : {0.5, 0.9, 0.99, 1.0})
      deltas.push_back(sorted[static_cast<std::size_t>(quantile * static_cast<double>(sorted.size() - 1))]);
  return deltas;
}

void expect_kruskals_partition(const Field &field)
{
  for (const Exterior exterior : {Exterior::none, Exterior::infinite}) {
    const auto tree = naive_tree(field, exterior);
    const RegionMerge merge = merge_of(field, exterior, {7, 9});
    const auto persistences = positive_persistences(tree);
    EXPECT_TRUE(positive_persistences(merge.hierarchy) == persistences);
    for (const float delta : five_deltas(persistences))
      EXPECT_TRUE(partition_of(merge, delta) == naive_partition(tree, node_count(field, exterior), delta))
          << "delta " << delta;
  }
}

class RealVolume : public testing::TestWithParam<const char *> {
protected:
  void SetUp() override
  {
    const auto path = data_folder() / GetParam();
    if (!std::filesystem::exists(path))
      GTEST_SKIP() << path.string() << " is not there; `scripts/fetch_data.sh DIR` fetches it, VOLSURF_DATA=DIR names "
                   << "the folder";
    crop_ = middle_of(read_volume(path).volume);
  }

  Volume crop_;
};

} // namespace

TEST_P(RealVolume, PartitionOfTheGradientIsKruskals)
{
  expect_kruskals_partition(field_of(crop_, {0.0, false}));
}

TEST_P(RealVolume, PartitionOfTheSmoothedGradientIsKruskals)
{
  expect_kruskals_partition(field_of(crop_, {}));
}

TEST_P(RealVolume, PartitionOfAnEdgeMapIsKruskals)
{
  expect_kruskals_partition(field_of(crop_, {0.0, true}));
}

INSTANTIATE_TEST_SUITE_P(Fetched, RealVolume,
                         testing::Values("ch2.nii.gz", "ch2bet.nii.gz", "ch2better.nii.gz", "cranium.nhdr",
                                         "liver.nhdr", "skull.nhdr"),
                         [](const auto &test) {
                           const std::string name = test.param;
                           return name.substr(0, name.find('.'));
                         });
