#include "volsurf/pipeline/run.h"

#include "volsurf/core/parallel.h"
#include "volsurf/interop/openvdb_grid.h"
#include "volsurf/io/output_file.h"
#include "volsurf/io/write_mesh.h"
#include "volsurf/io/write_volume.h"
#include "volsurf/surface/extract.h"
#include "volsurf/topology/region_merge.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
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
  for (const auto &file : {settings.labels, settings.report})
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
  if (!(settings.delta > 0 && std::isfinite(settings.delta)))
    throw UsageError("--delta: found " + std::to_string(settings.delta) + "; allowed are finite numbers above 0");
  if (!settings.seeds_mm.empty() && settings.surface == SurfaceKind::hull)
    throw UsageError("--seed and --surface hull exclude each other: a seed's region has a boundary of its own");
  check_smoothing(settings.smoothing);
  for (const auto &output : settings.outputs)
    output_kind_of(output);
  if (settings.labels)
    require_nrrd_extension(*settings.labels);
  require_distinct_files(settings);
}

/// The region that what lies outside the volume belongs to.
RegionId background_region(const RegionMerge &merge, const Regions &regions)
{
  if (merge.hierarchy.exterior)
    return regions.of_basin[*merge.hierarchy.exterior];
  const auto faces = count_border_faces(merge.cells, regions.of_basin, regions.count());
  return static_cast<RegionId>(std::max_element(faces.begin(), faces.end()) - faces.begin());
}

/// The region of the cell that holds a point.
RegionId region_at(const Vec3 &seed_mm, const Settings &settings, const Grid &grid, const RegionMerge &merge,
                   const Regions &regions)
{
  const double sign = settings.frame == Frame::ras ? -1 : 1;
  const Vec3 index = world_to_index(grid, {sign * seed_mm[0], sign * seed_mm[1], seed_mm[2]});
  std::array<std::int64_t, 3> cell{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto last = static_cast<double>(grid.size[axis] - 1);
    if (!(index[axis] >= 0 && index[axis] <= last)) {
      std::ostringstream message;
      message << "--seed " << seed_mm[0] << ',' << seed_mm[1] << ',' << seed_mm[2] << ": it lies outside the volume";
      throw UsageError(message.str());
    }
    cell[axis] = std::min(static_cast<std::int64_t>(index[axis]), grid.size[axis] - 2);
  }
  return regions.of_basin[merge.cells.basins[CellGrid(merge.cells.size).id(cell[0], cell[1], cell[2])]];
}

/// What the surface is to separate, and whether it is the boundary of one thing only.
struct Selection {
  Sides sides;
  bool one_thing;
};

Selection select_sides(const Settings &settings, const Grid &grid, const RegionMerge &merge, const Regions &regions,
                       RegionId background)
{
  std::vector<RegionId> side(regions.count() + 1);
  if (settings.surface == SurfaceKind::hull)
    std::fill(side.begin() + 1, side.end(), RegionId{1});
  else if (settings.seeds_mm.empty())
    std::iota(side.begin(), side.end(), RegionId{0});
  side[background] = 0;
  for (const Vec3 &seed : settings.seeds_mm) {
    const RegionId region = region_at(seed, settings, grid, merge, regions);
    side[region] = region;
  }
  Selection selection{{regions.of_basin, side[background]}, false};
  for (RegionId &basin_side : selection.sides.of_basin)
    basin_side = side[basin_side];
  std::sort(side.begin(), side.end());
  selection.one_thing = std::unique(side.begin(), side.end()) - side.begin() == 2;
  return selection;
}

std::string number(double value)
{
  std::ostringstream out;
  out << value;
  return out.str();
}

void require_boundary(const Settings &settings, const Hierarchy &hierarchy, const Regions &regions)
{
  if (regions.count() < 2)
    throw EmptyResult(settings.input.string() + ": no boundary survives delta = " + number(settings.delta) +
                      "; the largest persistence is " + number(hierarchy.largest_persistence()));
}

void summarise_regions(const RegionMerge &merge, const Regions &regions, Report &report)
{
  constexpr std::size_t kMost = 20;
  const Hierarchy &hierarchy = merge.hierarchy;
  const Index3 &n = merge.cells.size;
  for (std::size_t rank = 0; rank < std::min(kMost, regions.count()); ++rank) {
    const BasinId basin = hierarchy.by_rank[rank];
    if (hierarchy.roots[basin] < 0)
      continue; // the exterior has no place
    const CellId root = hierarchy.roots[basin];
    const RegionId id = regions.of_basin[basin];
    const Vec3 centre{static_cast<double>(root % n[0]) + 0.5, static_cast<double>(root / n[0] % n[1]) + 0.5,
                      static_cast<double>(root / n[0] / n[1]) + 0.5};
    report.strongest_regions.push_back(
        {id, hierarchy.persistence[basin], regions.cell_counts[id - 1], index_to_world(report.grid, centre)});
  }
  report.basins = static_cast<std::int64_t>(hierarchy.basin_count());
  report.largest_persistence = hierarchy.largest_persistence();
  report.regions = static_cast<std::int64_t>(regions.count());
}

void summarise_components(const Components &components, Report &report)
{
  report.boundary_faces = static_cast<std::int64_t>(components.of_face.size());
  report.components = static_cast<std::int64_t>(components.count());
  report.components_kept = static_cast<std::int64_t>(components.kept);
  report.component_sizes.assign(components.sizes.begin(),
                                components.sizes.begin() +
                                    static_cast<std::ptrdiff_t>(std::min<std::size_t>(components.kept, 20)));
}

void collect_warnings(Report &report)
{
  if (report.non_finite_gradients > 0)
    report.warnings.push_back(std::to_string(report.non_finite_gradients) +
                              " samples have no finite gradient and were taken as walls");
  if (report.mesh.watertight && std::abs(report.smoothing.volume_drift) > kLargestVolumeDrift)
    report.warnings.push_back("smoothing changed the enclosed volume by " +
                              number(100 * report.smoothing.volume_drift) + " %; try a smaller --smooth");
}

LabelVolume region_labels(const Grid &grid, const RegionMerge &merge, const Regions &regions)
{
  LabelVolume labels{cell_centre_grid(grid), std::vector<std::uint32_t>(static_cast<std::size_t>(grid.cell_count()))};
  std::transform(merge.cells.basins.begin(), merge.cells.basins.end(), labels.labels.begin(),
                 [&](BasinId basin) { return regions.of_basin[basin]; });
  return labels;
}

void write_text(const std::string &text, const std::filesystem::path &path)
{
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file)
    throw OutputError(path.string() + ": it could not be written; is the disk full?");
}

std::string replaced(std::string text, const std::string &part, const std::string &by)
{
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + by.size()))
    text.replace(at, part.size(), by);
  return text;
}

/// Errors name the file that the user asked for, not the temporary one.
void write_pending(const PendingOutput &output, const std::function<void(const std::filesystem::path &)> &write)
{
  try {
    write(output.temporary_path());
  } catch (const OutputError &error) {
    throw OutputError(replaced(error.what(), output.temporary_path().string(), output.target().string()));
  }
}

/// All files of a run. They appear together, at the end.
class Outputs {
public:
  explicit Outputs(const Settings &settings) : settings_(settings)
  {
    for (const auto &path : settings.outputs)
      results_.emplace_back(path);
    if (settings.labels)
      labels_.emplace(*settings.labels);
    if (settings.report)
      report_.emplace(*settings.report);
  }

  bool needs_labels() const
  {
    return labels_ || std::any_of(settings_.outputs.begin(), settings_.outputs.end(), is_vdb);
  }

  void write_results(const Mesh &mesh, const LabelVolume &labels, const EdgeField &field, const Grid &grid)
  {
    const Provenance provenance{version_text(), settings_.input.filename().string(), describe(settings_)};
    for (const PendingOutput &output : results_)
      write_pending(output, [&](const std::filesystem::path &path) {
        if (is_vdb(output.target()))
          write_vdb(labels, gradient_magnitude(field, grid), path, provenance, settings_.frame);
        else
          write_mesh(mesh, output_kind_of(output.target()), path, provenance, settings_.frame);
      });
    if (labels_)
      write_pending(*labels_, [&](const std::filesystem::path &path) { write_labels(labels, path, provenance); });
  }

  void write_report(const Report &report)
  {
    if (report_)
      write_pending(*report_, [&](const std::filesystem::path &path) { write_text(to_json(report), path); });
  }

  void commit()
  {
    for (PendingOutput &output : results_)
      output.commit();
    for (auto *output : {&labels_, &report_})
      if (*output)
        (*output)->commit();
  }

private:
  static bool is_vdb(const std::filesystem::path &path) { return output_kind_of(path) == OutputKind::vdb; }

  const Settings &settings_;
  std::vector<PendingOutput> results_;
  std::optional<PendingOutput> labels_;
  std::optional<PendingOutput> report_;
};

} // namespace

Report run(const Settings &settings, const Progress &progress, const std::function<void(const Report &)> &publish)
{
  check_settings(settings);
  const ThreadLimit limit(settings.threads);
  StageTimer timer;
  Report report;
  report.settings = settings;
  report.threads = settings.threads > 0 ? settings.threads : available_threads();

  report_progress(progress, "read", 0);
  const InputVolume input = read_volume(settings.input, {settings.series_uid, physical_memory_bytes()});
  Outputs outputs(settings);
  const Grid &grid = input.volume.grid;
  report.source = input.source;
  report.pixel_type = input.pixel_type;
  report.warnings = input.warnings;
  report.grid = grid;
  timer.lap("read");

  const EdgeField field(input.volume, settings.field);
  report.sigma_mm = field.sigma_mm();
  const RegionMerge merge = merge_regions(grid.size, field.planes(), {settings.exterior}, progress);
  report.non_finite_gradients = field.non_finite_count();
  timer.lap("gradient and merge");

  const Regions regions = cut(merge.hierarchy, settings.delta);
  require_boundary(settings, merge.hierarchy, regions);
  report.background_region = background_region(merge, regions);
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
                                        regions.maxima[report.background_region - 1],
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
  outputs.write_results(mesh, outputs.needs_labels() ? region_labels(grid, merge, regions) : LabelVolume{}, field,
                        grid);
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
