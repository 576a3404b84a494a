#include "volsurf/core/parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace volsurf {

struct ThreadLimit::Control {
  tbb::global_control threads;
};

std::int64_t slab_count(std::int64_t count, std::int64_t planes_per_slab)
{
  return (count + planes_per_slab - 1) / planes_per_slab;
}

void parallel_for_slabs(std::int64_t count, std::int64_t planes_per_slab, const std::function<void(const Slab &)> &work)
{
  tbb::parallel_for(std::int64_t{0}, slab_count(count, planes_per_slab), [&](std::int64_t index) {
    const std::int64_t begin = index * planes_per_slab;
    work({index, begin, std::min(begin + planes_per_slab, count)});
  });
}

int available_threads()
{
  return tbb::info::default_concurrency();
}

int active_threads()
{
  const std::size_t limit = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::min(static_cast<int>(limit), available_threads());
}

std::int64_t large_slab(std::int64_t count)
{
  const std::int64_t slabs = active_threads() == 1 ? 1 : 2 * active_threads();
  return std::max<std::int64_t>((count + slabs - 1) / slabs, std::min<std::int64_t>(count, 16));
}

ThreadLimit::ThreadLimit(int threads)
    : control_(new Control{{tbb::global_control::max_allowed_parallelism,
                            static_cast<std::size_t>(threads > 0 ? threads : available_threads())}})
{
}

ThreadLimit::~ThreadLimit() = default;

} // namespace volsurf
