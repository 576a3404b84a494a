#include "volsurf/core/parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#ifdef __SANITIZE_THREAD__
#include <atomic>
#include <thread>
#include <vector>
#endif

namespace volsurf {

namespace {

using Work = std::function<void(std::int64_t index)>;

#ifdef __SANITIZE_THREAD__
/// ThreadSanitizer cannot see how Debian's TBB, which is not instrumented, hands work from thread to thread, and
/// reports races that there are not. So that it can judge ours, its builds use threads that it does see.
void for_each_index(std::int64_t count, const Work &work)
{
  std::atomic<std::int64_t> next{0};
  std::exception_ptr error;
  std::atomic<bool> failed{false};
  const auto run = [&] {
    for (std::int64_t index = next++; index < count && !failed; index = next++)
      try {
        work(index);
      } catch (...) {
        if (!failed.exchange(true))
          error = std::current_exception();
      }
  };
  std::vector<std::thread> threads(static_cast<std::size_t>(std::min<std::int64_t>(count, active_threads())));
  for (std::thread &thread : threads)
    thread = std::thread(run);
  for (std::thread &thread : threads)
    thread.join();
  if (error)
    std::rethrow_exception(error);
}
#else
void for_each_index(std::int64_t count, const Work &work)
{
  tbb::parallel_for(std::int64_t{0}, count, work);
}
#endif

} // namespace

struct ThreadLimit::Control {
  tbb::global_control threads;
};

std::int64_t slab_count(std::int64_t count, std::int64_t planes_per_slab)
{
  return (count + planes_per_slab - 1) / planes_per_slab;
}

void parallel_for_slabs(std::int64_t count, std::int64_t planes_per_slab, const std::function<void(const Slab &)> &work)
{
  for_each_index(slab_count(count, planes_per_slab), [&](std::int64_t index) {
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
