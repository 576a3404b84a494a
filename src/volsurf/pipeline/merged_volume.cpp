#include "volsurf/pipeline/merged_volume.h"

#include "volsurf/core/error.h"
#include "volsurf/core/timer.h"

#include <sstream>

namespace volsurf {

namespace {

/// A run that would swap or be killed is better refused before it begins.
void require_memory(const Settings &settings, const Grid &grid)
{
  const std::uint64_t needed = expected_memory_bytes(grid);
  const std::uint64_t allowed = settings.max_memory_bytes.value_or(available_memory_bytes());
  if (needed <= allowed)
    return;
  std::ostringstream message;
  message.precision(3);
  message << settings.input.string() << ": found " << grid.size[0] << " x " << grid.size[1] << " x " << grid.size[2]
          << " samples, which need " << static_cast<double>(needed) / 1e9
          << " GB; allowed: " << static_cast<double>(allowed) / 1e9 << " GB ("
          << (settings.max_memory_bytes ? "--max-memory" : "what is available") << ")";
  throw InputError(message.str());
}

} // namespace

std::uint64_t expected_memory_bytes(const Grid &grid)
{
  constexpr double kBytesPerSample = 4 + 12; // float32 samples; labels, saddles, basins and faces
  constexpr double kProgramBytes = 8e7;
  const double samples =
      static_cast<double>(grid.size[0]) * static_cast<double>(grid.size[1]) * static_cast<double>(grid.size[2]);
  return static_cast<std::uint64_t>(kProgramBytes + kBytesPerSample * samples);
}

MergedVolume read_input(const Settings &settings, const Progress &progress,
                        const std::function<void(const Grid &)> &found)
{
  report_progress(progress, "read", 0);
  const auto check_grid = [&](const Grid &grid) {
    if (found)
      found(grid);
    require_memory(settings, grid);
  };
  MergedVolume merged;
  merged.input = read_volume(settings.input, {settings.series_uid, check_grid});
  merged.field = settings.field;
  merged.exterior = settings.exterior;
  return merged;
}

void merge_input(MergedVolume &merged, const Progress &progress)
{
  if (merged.is_merged())
    return;
  const Volume &volume = merged.input.volume;
  const EdgeField field(volume, merged.field);
  merged.merge = merge_regions(volume.grid.size, field.planes(), {merged.exterior}, progress);
  merged.non_finite_gradients = field.non_finite_count();
}

} // namespace volsurf
