// Where a run spends its time and memory.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace volsurf {

/// Seconds per stage, in the order of the stages.
using StageSeconds = std::vector<std::pair<std::string, double>>;

/// Adds the wall time from one call of lap() to the next to a list.
class StageTimer {
public:
  /// The time since the last lap belongs to `stage`, and is added to what it had before.
  void lap(const std::string &stage)
  {
    const auto now = std::chrono::steady_clock::now();
    const auto same = [&](const auto &entry) { return entry.first == stage; };
    auto entry = std::find_if(seconds_.begin(), seconds_.end(), same);
    if (entry == seconds_.end())
      entry = seconds_.insert(entry, {stage, 0.0});
    entry->second += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

  const StageSeconds &seconds() const { return seconds_; }

private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  StageSeconds seconds_;
};

/// The most memory that the process has had so far.
std::int64_t peak_memory_bytes();

/// The memory that this machine can still give without swapping.
std::uint64_t available_memory_bytes();

} // namespace volsurf
