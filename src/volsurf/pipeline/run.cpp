#include "volsurf/pipeline/run.h"

#include "volsurf/core/parallel.h"
#include "volsurf/io/write_mesh.h"
#include "volsurf/io/write_volume.h"
#include "volsurf/pipeline/file_names.h"
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
  const Settings settings = settings_of_merge(requested, merged);
  Outputs outputs(settings);
  const Grid &grid = merged.input.volume.grid;
  report.settings = settings;
  report.is_stored_merge = merged.is_stored;
  report.source = merged.input.source;
  report.pixel_type = merged.input.pixel_type;
  report.warnings = merged.input.warnings;
  report.grid = grid;
  timer.lap("read");

  merge_input(merged, progress);
  const RegionMerge &merge = merged.merge;
  const EdgeField field(merged.input.volume, merged.field);
  report.sigma_mm = field.sigma_mm();
  report.non_finite_gradients = merged.non_finite_gradients;
  timer.lap("gradient and merge");

  report.decision = decide_delta(settings, merged, field);
  timer.lap("delta");

  const Regions regions = cut(merge.hierarchy, report.decision.delta);
  require_boundary(settings, report.decision.delta, merge.hierarchy, regions);
  report.background_region = regions.of_basin[merge.hierarchy.background];
  summarise_regions(merge, regions, report);
  timer.lap("cut");

  const Selection selection = select_sides(settings, grid, merge, regions, report.background_region);
  const Provenance provenance{version_text(), source_name(merged), describe(settings, report.decision.delta)};
  make_surfaces({merged.input.volume, field.sigma_mm(), merge, regions, report.background_region}, settings, selection,
                {outputs, report, timer, progress, provenance});
  warn_of_missing_segments(selection, report);
  collect_warnings(report);

  report_progress(progress, "write", 0);
  outputs.write_volumes({field, merged, regions, selection}, provenance);
  timer.lap("write");
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
