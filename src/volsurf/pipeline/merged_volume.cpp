#include "volsurf/pipeline/merged_volume.h"

#include "volsurf/core/error.h"
#include "volsurf/field/median.h"
#include "volsurf/field/oversample.h"
#include "volsurf/pipeline/choose_grid.h"
#include "volsurf/pipeline/stored_merge.h"

#include <sstream>

namespace volsurf {

namespace {

/// What is given a second time must be what the file holds already.
void require_options_of(const MergedVolume &merged, const Settings &settings)
{
  const double sigma_mm = EdgeField(merged.input.volume, merged.field).sigma_mm();
  const FieldOptions &wanted = settings.field;
  const bool same_sigma = !wanted.sigma_mm || (*wanted.sigma_mm == sigma_mm && !merged.field.edge_map);
  const int oversampling = merged.input.volume.grid.oversampling;
  const bool same_input = (!wanted.edge_map || merged.field.edge_map) &&
                          (settings.series_uid.empty() || settings.series_uid == merged.series_uid) &&
                          settings.median_voxels.value_or(merged.median_voxels) == merged.median_voxels &&
                          settings.oversampling.value_or(oversampling) == oversampling;
  if (same_sigma && same_input && settings.exterior.value_or(merged.exterior) == merged.exterior)
    return;
  std::ostringstream message;
  message << settings.input.string() << ": found the hierarchy of " << source_name(merged) << ", made with ";
  if (merged.median_voxels > 0)
    message << "--median " << merged.median_voxels << ' ';
  if (oversampling > 1)
    message << "--oversample " << oversampling << ' ';
  if (merged.field.edge_map)
    message << "--edge-map";
  else
    message << "--sigma " << sigma_mm;
  message << " --exterior " << (merged.exterior == Exterior::infinite ? "infinite" : "none");
  if (!merged.series_uid.empty())
    message << " --series " << merged.series_uid;
  message << "; allowed: no other values of these options, for which the scan itself is needed";
  throw UsageError(message.str());
}

} // namespace

Grid corner_grid(const MergedVolume &merged)
{
  const Grid &grid = merged.input.volume.grid;
  return merged.cells_are_voxels ? voxel_corner_grid(grid) : grid;
}

std::uint64_t expected_memory_bytes(const Grid &grid, Method method)
{
  constexpr double kBytesPerSample = 4 + 12;      // float32 samples; labels, saddles, basins and faces
  constexpr double kFloodingBytesPerSample = 440; // of noise; a quarter of it without
  constexpr double kProgramBytes = 8e7;
  const double per_sample = kBytesPerSample + (method == Method::watershed ? kFloodingBytesPerSample : 0);
  const double samples =
      static_cast<double>(grid.size[0]) * static_cast<double>(grid.size[1]) * static_cast<double>(grid.size[2]);
  return static_cast<std::uint64_t>(kProgramBytes + per_sample * samples);
}

void require_memory(const Settings &settings, const Grid &grid, std::uint64_t needed_bytes)
{
  const std::uint64_t allowed = allowed_memory_bytes(settings);
  if (needed_bytes <= allowed)
    return;
  std::ostringstream message;
  message.precision(3);
  message << settings.input.string() << ": found " << grid.size[0] << " x " << grid.size[1] << " x " << grid.size[2]
          << " samples, which need " << static_cast<double>(needed_bytes) / 1e9
          << " GB; allowed: " << static_cast<double>(allowed) / 1e9 << " GB ("
          << (settings.max_memory_bytes ? "--max-memory" : "what is available") << ")";
  throw InputError(message.str());
}

MergedVolume read_input(const Settings &settings, const Progress &progress,
                        const std::function<void(const Grid &)> &found)
{
  report_progress(progress, "read", 0);
  const auto check_grid = [&](const Grid &grid) {
    if (found)
      found(grid);
    require_memory(settings, grid, expected_memory_bytes(grid, settings.method));
  };
  bool scan_decides = false;
  const auto check_scan = [&](const Grid &scan) {
    scan_decides = leaves_oversampling_to_scan(settings, scan);
    if (!scan_decides)
      check_grid(oversampled_grid(scan, settings.oversampling.value_or(1)));
  };
  MergedVolume merged;
  if (is_stored_merge(settings.input)) {
    merged = read_merge(settings.input, check_grid);
    require_options_of(merged, settings);
    return merged;
  }
  merged.input = read_volume(settings.input, {settings.series_uid, check_scan});
  merged.series_uid = settings.series_uid;
  merged.median_voxels = settings.median_voxels.value_or(0);
  filter_by_median(merged.input.volume, merged.median_voxels, progress);
  Volume &volume = merged.input.volume;
  oversample(volume, scan_decides ? choose_oversampling(volume) : settings.oversampling.value_or(1));
  if (scan_decides)
    check_grid(volume.grid);
  merged.field = settings.field;
  merged.exterior = settings.exterior.value_or(MergeOptions{}.exterior);
  return merged;
}

std::string source_name(const MergedVolume &merged)
{
  const std::filesystem::path path = merged.input.source.path;
  return (path.has_filename() ? path : path.parent_path()).filename().string(); // folder/ has none
}

Settings settings_of_merge(Settings settings, const MergedVolume &merged)
{
  settings.series_uid = merged.series_uid;
  settings.median_voxels = merged.median_voxels;
  settings.oversampling = merged.input.volume.grid.oversampling;
  if (!settings.field.sigma_mm)
    settings.field.sigma_mm = merged.field.sigma_mm;
  settings.field.edge_map = merged.field.edge_map;
  settings.exterior = merged.exterior;
  return settings;
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
