#include "volsurf/pipeline/run.h"

#include "volsurf/core/parallel.h"
#include "volsurf/io/write_mesh.h"
#include "volsurf/io/write_volume.h"
#include "volsurf/pipeline/merged_volume.h"
#include "volsurf/pipeline/outputs.h"
#include "volsurf/pipeline/selection.h"
#include "volsurf/pipeline/stored_merge.h"
#include "volsurf/pipeline/summary.h"
#include "volsurf/surface/extract.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace volsurf {

namespace {

/// The one name of a file, whether it exists or not. A name that cannot be followed stays as it is, for the reader or
/// the writer to refuse.
std::filesystem::path place_of(const std::filesystem::path &file)
{
  std::error_code error;
  const std::filesystem::path place = std::filesystem::weakly_canonical(std::filesystem::absolute(file, error), error);
  return error ? file : place;
}

void require_distinct_files(const Settings &settings)
{
  std::vector<std::filesystem::path> files = settings.outputs;
  for (const auto &file : {settings.labels, settings.report, settings.hierarchy})
    if (file)
      files.push_back(*file);
  files.push_back(settings.input);
  for (auto &file : files)
    file = place_of(file);
  for (auto file = files.begin(); file != files.end(); ++file)
    if (std::find(files.begin(), file, *file) != file)
      throw UsageError(file->string() + ": it is named twice; inputs and outputs must be different files");
}

void check_settings(const Settings &settings)
{
  if (!settings.seeds_mm.empty() && settings.surface == SurfaceKind::hull)
    throw UsageError("--seed and --surface hull exclude each other: a seed's region has a boundary of its own");
  check_smoothing(settings.smoothing);
  for (const auto &output : settings.outputs)
    output_kind_of(output);
  if (settings.labels)
    require_nrrd_extension(*settings.labels);
  if (settings.hierarchy)
    require_hierarchy_extension(*settings.hierarchy);
  require_distinct_files(settings);
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

  report_progress(progress, "boundary", 0);
  const Selection selection = select_sides(settings, grid, merge, regions, report.background_region);
  FaceSet faces = find_boundary(merge.cells, selection.sides);
  timer.lap("boundary");

  report_progress(progress, "components", 0);
  const Components components = find_components(faces, grid, settings.components);
  summarise_components(components, report);
  timer.lap("components");

  report_progress(progress, "surface", 0);
  const RegionsOfCells regions_of_cells{merge.cells, regions.of_basin, report.background_region,
                                        merge.hierarchy.background,
                                        [&](BasinId a, BasinId b) { return saliency(merge.hierarchy, a, b); }};
  Mesh mesh = extract_mesh(keep_components(std::move(faces), components), grid, selection.sides, regions_of_cells,
                           selection.one_thing);
  timer.lap("surface");

  report_progress(progress, "smooth", 0);
  report.smoothing = smooth_mesh(mesh, grid, settings.smoothing);
  timer.lap("smooth");
  report.mesh = check_mesh(mesh);
  collect_warnings(report);
  timer.lap("check");

  report_progress(progress, "write", 0);
  outputs.write_results({report.decision.delta, mesh, field, merged, regions});
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
