#include "volsurf/core/timer.h"

#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace volsurf {

std::int64_t peak_memory_bytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{1024} * usage.ru_maxrss;
}

std::uint64_t available_memory_bytes()
{
  std::ifstream lines("/proc/meminfo");
  for (std::string name, unit; lines >> name;) {
    std::uint64_t kibibytes = 0;
    lines >> kibibytes;
    std::getline(lines, unit);
    if (name == "MemAvailable:")
      return 1024 * kibibytes;
  }
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGE_SIZE));
}

} // namespace volsurf
