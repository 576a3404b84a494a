#include "progress_bar.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

namespace volsurf {

namespace {

constexpr int kWidth = 30;

} // namespace

ProgressBar::ProgressBar(bool wanted)
    : enabled_(wanted && isatty(STDERR_FILENO) != 0), colour_(std::getenv("NO_COLOR") == nullptr)
{
}

ProgressBar::~ProgressBar()
{
  wipe();
}

void ProgressBar::wipe()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!drawn_.empty())
    std::fprintf(stderr, "\r%*s\r", 60, "");
  drawn_.clear();
}

void ProgressBar::show(std::string_view stage, double fraction)
{
  if (!enabled_)
    return;
  const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kWidth);
  std::string line(stage);
  line.resize(12, ' ');
  line += colour_ ? "\033[36m" : "";
  line += std::string(static_cast<std::size_t>(filled), '#');
  line += colour_ ? "\033[0m" : "";
  line += std::string(static_cast<std::size_t>(kWidth - filled), '.');
  const std::lock_guard<std::mutex> lock(mutex_);
  if (line == drawn_)
    return;
  drawn_ = line;
  std::fprintf(stderr, "\r%s", line.c_str());
  std::fflush(stderr);
}

} // namespace volsurf
