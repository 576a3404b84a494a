#include "volsurf/pipeline/compare_files.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"
#include "volsurf/io/output_file.h"
#include "volsurf/io/read_mesh.h"
#include "volsurf/io/write_mesh.h"
#include "volsurf/pipeline/comparison_report.h"
#include "volsurf/pipeline/file_names.h"
#include "volsurf/pipeline/settings.h"

#include <cmath>
#include <utility>

namespace volsurf {

namespace {

/// What shape_of_surface and shape_of_labels refuse, they cannot name.
template <typename Make> Shape named_shape(const std::filesystem::path &path, Make make)
{
  try {
    return make();
  } catch (const InputError &error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

void check_settings(const CompareSettings &settings)
{
  if (settings.distance)
    require_extension(*settings.distance, ".vtp");
  if (!settings.labels.empty() && has_mesh_extension(settings.a) && has_mesh_extension(settings.b))
    throw UsageError("--label: A and B are surfaces; allowed with a label volume");
  for (const auto &input : {settings.a, settings.b}) {
    std::vector<std::filesystem::path> files{input};
    for (const auto &output : {settings.json, settings.distance})
      if (output)
        files.push_back(*output);
    require_distinct_files(files);
  }
}

void write_distances(const ComparedFiles &files, const std::filesystem::path &path)
{
  const std::vector<double> &signed_mm = files.comparison.distances.a_to_b.at_vertices_mm;
  PointArray side{"SignedDistance", {}};
  PointArray distance{"DistanceToB", {}};
  for (const double value : signed_mm) {
    side.values.push_back(static_cast<float>(value));
    distance.values.push_back(static_cast<float>(std::abs(value)));
  }
  std::vector<PointArray> arrays{distance};
  if (files.b.shape.is_closed())
    arrays.insert(arrays.begin(), side);
  const Provenance provenance{version_text(), files.a.path.filename().string(),
                              "volsurf-compare, distances to " + files.b.path.filename().string()};
  write_vtp(files.a.shape.surface, arrays, path, provenance, files.a.frame);
}

} // namespace

ComparedFile read_compared_file(const std::filesystem::path &path, const CompareSettings &settings)
{
  ComparedFile file;
  file.path = path;
  if (has_mesh_extension(path)) {
    InputMesh input = read_mesh(path, settings.frame);
    file.frame = input.frame_mark.value_or(settings.frame);
    file.frame_is_assumed = !input.frame_mark;
    file.shape = named_shape(path, [&] { return shape_of_surface(std::move(input.mesh)); });
    return file;
  }
  InputVolume input = read_volume(path);
  file.warnings = std::move(input.warnings);
  file.shape = named_shape(path, [&] { return shape_of_labels(input.volume, settings.labels); });
  return file;
}

ComparedFiles compare_files(const CompareSettings &settings, const Progress &progress,
                            const std::function<void(const ComparedFiles &)> &publish)
{
  check_settings(settings);
  const ThreadLimit limit(settings.threads);
  std::optional<PendingOutput> json;
  std::optional<PendingOutput> distance;
  if (settings.json)
    json.emplace(*settings.json);
  if (settings.distance)
    distance.emplace(*settings.distance);

  ComparedFiles files;
  files.settings = settings;
  report_progress(progress, "read A", 0);
  files.a = read_compared_file(settings.a, settings);
  report_progress(progress, "read B", 0);
  files.b = read_compared_file(settings.b, settings);
  files.comparison = compare(files.a.shape, files.b.shape, settings.options, progress);

  report_progress(progress, "write", 0);
  if (json)
    json->write([&](const std::filesystem::path &path) { write_bytes(to_json(files), path); });
  if (distance)
    distance->write([&](const std::filesystem::path &path) { write_distances(files, path); });
  report_progress(progress, "write", 1);
  if (publish)
    publish(files);
  for (auto *output : {&json, &distance})
    if (*output)
      (*output)->commit();
  return files;
}

} // namespace volsurf
