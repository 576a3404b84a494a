// A line of progress on a terminal.
#pragma once

#include <mutex>
#include <string>
#include <string_view>

namespace volsurf {

/// Draws on stderr, only where that is a terminal, and wipes the line when it goes. Thread-safe.
class ProgressBar {
public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar();
  ProgressBar(const ProgressBar &) = delete;
  ProgressBar &operator=(const ProgressBar &) = delete;

  void show(std::string_view stage, double fraction);
  void wipe();

private:
  bool enabled_;
  bool colour_;
  std::mutex mutex_;
  std::string drawn_;
};

} // namespace volsurf
