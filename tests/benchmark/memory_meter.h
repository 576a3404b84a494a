// The memory of this process, from /proc.
#pragma once

#include <cstdint>

namespace volsurf::bench {

/// What the process has in memory now.
std::int64_t resident_bytes();

/// The most that it had since reset_peak(). Where the kernel does not let a process reset it, since its start.
std::int64_t peak_resident_bytes();

/// Gives back what the allocator keeps of freed memory, so that a computation does not live on what reading has left,
/// and starts the peak anew.
void reset_peak();

} // namespace volsurf::bench
