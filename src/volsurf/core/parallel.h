// Threads. Work is cut into slabs whose results go to places of their own, so that the number of threads never shows in
// an output.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

namespace volsurf {

/// Half-open range of planes (or of any other index), the `index`-th of its partition.
struct Slab {
  std::int64_t index;
  std::int64_t begin;
  std::int64_t end;
};

/// The number of slabs that parallel_for_slabs makes of `count` planes.
std::int64_t slab_count(std::int64_t count, std::int64_t planes_per_slab);

/// Calls work(slab) once for each slab of 0 .. count-1, on the threads that a ThreadLimit allows. The first exception
/// that a call throws is thrown again here, after the others have stopped.
void parallel_for_slabs(std::int64_t count, std::int64_t planes_per_slab,
                        const std::function<void(const Slab &)> &work);

/// Threads of this machine that the process may use.
int available_threads();

/// Threads that parallel_for_slabs uses now.
int active_threads();

/// A slab size for work that costs a few planes more per slab: few slabs, but two for each thread, so that a thread
/// that is held up does not hold up the others.
std::int64_t large_slab(std::int64_t count);

/// While it lives, parallel_for_slabs uses at most `threads` threads (0: all that are available).
class ThreadLimit {
public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit &) = delete;
  ThreadLimit &operator=(const ThreadLimit &) = delete;

private:
  struct Control;
  std::unique_ptr<Control> control_;
};

} // namespace volsurf
