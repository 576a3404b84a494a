#include "volsurf/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

using namespace volsurf;

TEST(ParallelForSlabs, VisitsEachPlaneOnceForAnyNumberOfThreads)
{
  for (const int threads : {0, 1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    for (const std::int64_t count : {0, 1, 7, 32, 100})
      for (const std::int64_t planes_per_slab : {1, 3, 32, 1000}) {
        std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
        parallel_for_slabs(count, planes_per_slab, [&](const Slab &slab) {
          for (std::int64_t plane = slab.begin; plane < slab.end; ++plane)
            ++visits[static_cast<std::size_t>(plane)];
        });
        for (const auto &visit : visits)
          EXPECT_EQ(visit, 1);
      }
  }
}

TEST(ParallelForSlabs, SlabsFollowEachOtherAndAreAsManyAsSlabCountSays)
{
  std::vector<Slab> slabs(static_cast<std::size_t>(slab_count(10, 4)));
  parallel_for_slabs(10, 4, [&](const Slab &slab) { slabs.at(static_cast<std::size_t>(slab.index)) = slab; });
  ASSERT_EQ(slabs.size(), 3U);
  EXPECT_EQ(slabs[0].begin, 0);
  for (std::size_t i = 1; i < slabs.size(); ++i)
    EXPECT_EQ(slabs[i].begin, slabs[i - 1].end);
  EXPECT_EQ(slabs[2].end, 10);
}

TEST(ParallelForSlabs, PassesAnExceptionOn)
{
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    EXPECT_THROW(parallel_for_slabs(50, 1,
                                    [](const Slab &slab) {
                                      if (slab.begin == 20)
                                        throw std::runtime_error("stop");
                                    }),
                 std::runtime_error);
  }
}
