#include "benchmark/memory_meter.h"

#include <malloc.h>

#include <fstream>
#include <stdexcept>
#include <string>

namespace volsurf::bench {

namespace {

/// The line `name:   N kB` of /proc/self/status.
std::int64_t status_bytes(const std::string &name)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.compare(0, name.size() + 1, name + ":") == 0)
      return std::int64_t{1024} * std::stoll(line.substr(name.size() + 1));
  throw std::runtime_error("/proc/self/status has no " + name);
}

} // namespace

std::int64_t resident_bytes()
{
  return status_bytes("VmRSS");
}

std::int64_t peak_resident_bytes()
{
  return status_bytes("VmHWM");
}

void reset_peak()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << '5';
}

} // namespace volsurf::bench
