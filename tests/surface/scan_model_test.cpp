#include "volsurf/surface/scan_model.h"

#include "support/box_mesh.h"
#include "support/fields.h"

#include "volsurf/core/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr std::int64_t kSize = 12;

Volume any_scan()
{
  Volume scan{cube(kSize), {}};
  Dice dice(3);
  for (std::int64_t i = 0; i < scan.grid.sample_count(); ++i)
    scan.samples.push_back(static_cast<float>(dice.between(0, 1000)));
  return scan;
}

Mesh any_box()
{
  return box({2.3, 3.1, -0.2}, {8.8, 7.6, 7.4});
}

ScanModel model_of(const Window &window, Inside inside)
{
  ScanModel model(window, any_scan(), inside);
  model.set_surface(any_box());
  return model;
}

Window whole_scan()
{
  return {{0, 0, 0}, cube(kSize), {kSize, kSize, kSize}};
}

bool is_outermost(const Index3 &p)
{
  return std::any_of(p.begin(), p.end(), [](std::int64_t i) { return i == 0 || i == kSize - 1; });
}

/// Over the samples that share a face or an edge with one and are not the outermost of the scan.
float least_part_around(const Index3 &p, const ScanModel &model)
{
  float least = 1;
  for_each_sample({3, 3, 3}, [&](const Index3 &offset, SampleId) {
    const Index3 q{p[0] + offset[0] - 1, p[1] + offset[1] - 1, p[2] + offset[2] - 1};
    const bool is_corner = offset[0] != 1 && offset[1] != 1 && offset[2] != 1;
    if (is_corner || is_outermost(q))
      return;
    least = std::min(least, model.shares.row(q[1], q[2])[q[0]]);
  });
  return least;
}

} // namespace

TEST(ScanModel, IsBeyondTheLayerByTheLeastPartOfTheVoxelsAround)
{
  const ScanModel model = model_of(whole_scan(), Inside::layered);
  int beyond = 0;
  for_each_sample({kSize, kSize, kSize}, [&](const Index3 &p, SampleId) {
    if (is_outermost(p))
      return;
    const float part = model.beyond_shares.row(p[1], p[2])[p[0]];
    EXPECT_EQ(part, least_part_around(p, model)) << p[0] << ' ' << p[1] << ' ' << p[2];
    beyond += part > 0 ? 1 : 0;
  });
  EXPECT_GT(beyond, 50);
}

TEST(ScanModel, HasNothingBeyondALayerWhereThereIsNone)
{
  const ScanModel model = model_of(whole_scan(), Inside::uniform);
  EXPECT_EQ(std::count(model.beyond_shares.values.begin(), model.beyond_shares.values.end(), 0.0F),
            static_cast<std::ptrdiff_t>(model.beyond_shares.values.size()));
}

TEST(ScanModel, OfAWindowIsThatOfTheWholeButAtTheWindowsFaces)
{
  Window window = whole_scan();
  window.begin = {1, 2, 0};
  window.grid.size = {10, 7, 9};
  window.grid.origin_mm = {1, 2, 0};
  const ScanModel whole = model_of(whole_scan(), Inside::layered);
  const ScanModel part = model_of(window, Inside::layered);
  for_each_sample({8, 5, 7}, [&](const Index3 &inner, SampleId) {
    const Index3 p{inner[0] + 1, inner[1] + 1, inner[2] + 1};
    EXPECT_EQ(part.samples.row(p[1], p[2])[p[0]], whole.samples.row(p[1] + 2, p[2])[p[0] + 1]);
    EXPECT_NEAR(part.shares.row(p[1], p[2])[p[0]], whole.shares.row(p[1] + 2, p[2])[p[0] + 1], 1e-6);
    EXPECT_NEAR(part.beyond_shares.row(p[1], p[2])[p[0]], whole.beyond_shares.row(p[1] + 2, p[2])[p[0] + 1], 1e-6);
  });
}

TEST(ScanModel, IsTheSameForAnyNumberOfThreads)
{
  const ScanModel expected = model_of(whole_scan(), Inside::layered);
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(model_of(whole_scan(), Inside::layered).beyond_shares.values, expected.beyond_shares.values);
  }
}
