#include "volsurf/pipeline/run.h"

#include "volsurf/core/parallel.h"
#include "volsurf/io/write_mesh.h"
#include "volsurf/io/write_volume.h"
#include "volsurf/pipeline/file_names.h"
#include "volsurf/pipeline/find_regions.h"
#include "volsurf/pipeline/isosurfaces.h"
#include "volsurf/pipeline/merged_volume.h"
#include "volsurf/pipeline/outputs.h"
#include "volsurf/pipeline/segments.h"
#include "volsurf/pipeline/selection.h"
#include "volsurf/pipeline/stored_merge.h"
#include "volsurf/pipeline/summary.h"
#include "volsurf/pipeline/surfaces.h"

#include <cmath>
#include <sstream>

namespace volsurf {

namespace {

void check_selection(const Settings &settings)
{
  const bool names_regions = !settings.seeds_mm.empty() || !settings.region_numbers.empty();
  const std::string naming = settings.seeds_mm.empty() ? "--region" : "--seed";
  const bool hull = settings.surface == SurfaceKind::hull;
  if (names_regions && hull)
    throw UsageError(naming + " and --surface hull exclude each other: a named region has a boundary of its own");
  if (names_regions && settings.min_volume_mm3 > 0)
    throw UsageError(naming + " and --min-volume exclude each other: a named region is wanted whatever its size");
  if (!(settings.min_volume_mm3 >= 0 && std::isfinite(settings.min_volume_mm3)))
    throw UsageError("--min-volume: found " + std::to_string(settings.min_volume_mm3) +
                     "; allowed are finite numbers from 0, in mm3");
  if (hull && settings.split == Split::regions)
    throw UsageError("--split regions and --surface hull exclude each other: a hull goes around all regions; "
                     "use --split components");
}

void check_outputs(const Settings &settings)
{
  for (const auto &output : settings.outputs)
    output_kind_of(output);
  if (settings.split != Split::none && surface_outputs(settings).empty())
    throw UsageError("--split: found no output that it can split; allowed are .vtp, .stl, .ply and .obj");
  if (settings.labels)
    require_nrrd_extension(*settings.labels);
  if (settings.hierarchy)
    require_hierarchy_extension(*settings.hierarchy);
  require_distinct_files(settings, settings.outputs);
}

void check_settings(const Settings &settings)
{
  check_method(settings);
  check_selection(settings);
  check_smoothing(settings.smoothing);
  check_outputs(settings);
}

void warn_of_missing_segments(const Selection &selection, Report &report)
{
  const std::size_t regions = selection.regions.size();
  if (report.settings.labels && is_segmentation(*report.settings.labels) && regions > kMostSegments)
    report.warnings.push_back(report.settings.labels->string() + " holds the " + std::to_string(kMostSegments) +
                              " largest of " + std::to_string(regions) +
                              " regions; choose by --min-volume, --region or a larger --delta");
}

void require_boundary(const Settings &settings, double delta, const Hierarchy &hierarchy, const Regions &regions)
{
  if (regions.count() < 2) {
    std::ostringstream message;
    message << settings.input.string() << ": no boundary survives delta = " << delta << "; the largest persistence is "
            << hierarchy.largest_persistence();
    throw EmptyResult(message.str());
  }
}

/// What is known before the work begins.
void describe_input(const MergedVolume &merged, const Settings &settings, Report &report)
{
  report.settings = settings;
  report.is_stored_merge = merged.is_stored;
  report.source = merged.input.source;
  report.pixel_type = merged.input.pixel_type;
  report.warnings = merged.input.warnings;
  report.grid = merged.input.volume.grid;
}

/// Delta and the regions that it leaves.
Regions cut_at_delta(const MergedVolume &merged, const EdgeField &field, const Settings &settings, Report &report,
                     StageTimer &timer)
{
  const Hierarchy &hierarchy = merged.merge.hierarchy;
  report.decision = decide_delta(settings, merged, field);
  timer.lap("delta");
  Regions regions = cut(hierarchy, report.decision.delta);
  require_boundary(settings, report.decision.delta, hierarchy, regions);
  summarise_regions(merged.merge, regions, report);
  timer.lap("cut");
  return regions;
}

/// All regions that a usual method found.
Regions all_regions(const MergedVolume &merged, const Settings &settings, Report &report)
{
  if (const auto *const level = std::get_if<DeltaValue>(&settings.delta))
    report.decision.delta = level->per_mm;
  constexpr double kAnyDelta = 1; // none joins them
  Regions regions = cut(merged.merge.hierarchy, kAnyDelta);
  report.regions = static_cast<std::int64_t>(regions.count());
  return regions;
}

/// The surfaces of a method that finds regions, and the volumes.
void extract_regions(MergedVolume &merged, const Settings &settings, Outputs &outputs, Report &report,
                     StageTimer &timer, const Progress &progress)
{
  const bool is_usual = settings.method != Method::volsurf;
  find_regions(merged, settings, progress);
  const Volume &volume = merged.input.volume;
  const EdgeField field(volume, merged.field);
  report.sigma_mm = field.sigma_mm();
  report.non_finite_gradients = merged.non_finite_gradients;
  timer.lap(is_usual ? method_text(settings.method) : "gradient and merge");

  const Regions regions =
      is_usual ? all_regions(merged, settings, report) : cut_at_delta(merged, field, settings, report, timer);
  report.background_region = regions.of_basin[merged.merge.hierarchy.background];
  const Grid corners = corner_grid(merged);
  const Selection selection = select_sides(settings, volume, corners, merged.merge, regions, report.background_region);
  const Provenance provenance{version_text(), source_name(merged), describe(settings, report.decision.delta)};
  make_surfaces({volume, corners, field.sigma_mm(), merged.merge, regions, report.background_region}, settings,
                selection, {outputs, report, timer, progress, provenance});
  warn_of_missing_segments(selection, report);
  report_progress(progress, "write", 0);
  outputs.write_volumes({field, merged, regions, selection}, provenance);
}

/// The surface of a method that finds none.
void extract_isosurface(const MergedVolume &merged, const Settings &settings, Outputs &outputs, Report &report,
                        StageTimer &timer, const Progress &progress)
{
  const Provenance provenance{version_text(), source_name(merged), describe(settings, 0)};
  make_isosurface(merged.input.volume, settings, {outputs, report, timer, progress, provenance});
  report_progress(progress, "write", 0);
}

} // namespace

Report run(const Settings &requested, const Progress &progress, const std::function<void(const Report &)> &publish,
           const std::function<void(const Grid &)> &found)
{
  check_settings(requested);
  const ThreadLimit limit(requested.threads);
  StageTimer timer;
  Report report;
  report.threads = requested.threads > 0 ? requested.threads : available_threads();

  MergedVolume merged = read_input(requested, progress, found);
  const Settings settings = settings_with_iso_value(settings_of_merge(requested, merged), merged.input.volume);
  Outputs outputs(settings);
  describe_input(merged, settings, report);
  timer.lap("read");

  if (finds_regions(settings.method))
    extract_regions(merged, settings, outputs, report, timer, progress);
  else
    extract_isosurface(merged, settings, outputs, report, timer, progress);
  timer.lap("write");
  collect_warnings(report);

  report.seconds = timer.seconds();
  report.peak_memory_bytes = peak_memory_bytes();
  outputs.write_report(report);
  report_progress(progress, "write", 1);
  if (publish)
    publish(report);
  outputs.commit();
  return report;
}

} // namespace volsurf
