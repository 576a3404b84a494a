#include "volsurf/pipeline/outputs.h"

#include "volsurf/core/error.h"
#include "volsurf/interop/openvdb_grid.h"
#include "volsurf/io/write_mesh.h"
#include "volsurf/io/write_volume.h"
#include "volsurf/pipeline/file_names.h"
#include "volsurf/pipeline/segments.h"
#include "volsurf/pipeline/stored_merge.h"

#include <algorithm>

namespace volsurf {

namespace {

LabelVolume region_labels(const Results &results)
{
  const Grid grid = corner_grid(results.merged);
  LabelVolume labels{cell_centre_grid(grid), std::vector<std::uint32_t>(static_cast<std::size_t>(grid.cell_count()))};
  const auto &basins = results.merged.merge.cells.basins;
  std::transform(basins.begin(), basins.end(), labels.labels.begin(),
                 [&](BasinId basin) { return results.regions.of_basin[basin]; });
  return labels;
}

void refuse_many_files(const Settings &settings, std::size_t files)
{
  if (files <= kMostFiles)
    return;
  const bool regions = settings.split == Split::regions;
  throw UsageError("--split " + split_text(settings.split) + ": found " + std::to_string(files) +
                   " files to write; allowed are up to " + std::to_string(kMostFiles) + ": use " +
                   (regions ? "--min-volume, --region" : "--keep, --min-volume") + " or a larger --delta");
}

} // namespace

Outputs::Outputs(const Settings &settings) : settings_(settings)
{
  const std::vector<std::filesystem::path> surfaces = surface_outputs(settings);
  if (settings.split == Split::none)
    surfaces_.emplace_back(surfaces.begin(), surfaces.end());
  else
    for (const auto &output : surfaces)
      PendingOutput(part_file(output, settings.split, 1, 1)); // the parts are not known yet, but where they will go
  for (const auto &output : settings.outputs)
    if (is_vdb(output))
      vdb_volumes_.emplace_back(output);
  if (settings.labels)
    labels_.emplace(*settings.labels);
  if (settings.report)
    report_.emplace(*settings.report);
  if (settings.hierarchy)
    hierarchy_.emplace(*settings.hierarchy);
}

void Outputs::expect_parts(const std::vector<std::uint32_t> &numbers)
{
  const std::vector<std::filesystem::path> outputs = surface_outputs(settings_);
  refuse_many_files(settings_, outputs.size() * numbers.size());
  std::vector<std::filesystem::path> files;
  for (const PendingOutput &output : vdb_volumes_)
    files.push_back(output.target());
  for (const std::uint32_t number : numbers)
    for (const auto &output : outputs)
      files.push_back(part_file(output, settings_.split, number, numbers.back()));
  require_distinct_files(settings_, files);
  auto file = files.begin() + static_cast<std::ptrdiff_t>(vdb_volumes_.size());
  for (std::size_t part = 0; part < numbers.size(); ++part, file += static_cast<std::ptrdiff_t>(outputs.size()))
    surfaces_.emplace_back(file, file + static_cast<std::ptrdiff_t>(outputs.size()));
}

std::vector<std::filesystem::path> Outputs::write_surface(std::size_t part, const Mesh &mesh,
                                                          const Provenance &provenance)
{
  std::vector<std::filesystem::path> files;
  for (const PendingOutput &output : surfaces_[part]) {
    output.write([&](const std::filesystem::path &path) {
      write_mesh(mesh, output_kind_of(output.target()), path, provenance, settings_.frame);
    });
    files.push_back(output.target());
  }
  return files;
}

void Outputs::write_volumes(const Results &results, const Provenance &provenance)
{
  const Grid &grid = results.merged.input.volume.grid;
  LabelVolume labels;
  if (labels_ || !vdb_volumes_.empty())
    labels = region_labels(results);
  for (const PendingOutput &output : vdb_volumes_)
    output.write([&](const std::filesystem::path &path) {
      write_vdb(labels, gradient_magnitude(results.field, grid), path, provenance, settings_.frame);
    });
  if (labels_ && is_segmentation(*settings_.labels)) {
    const std::vector<Segment> segments = make_segments(results.selection, results.regions, grid);
    keep_segments(segments, labels);
    labels_->write([&](const std::filesystem::path &path) { write_segmentation(labels, segments, path, provenance); });
  } else if (labels_) {
    labels_->write([&](const std::filesystem::path &path) { write_labels(labels, path, provenance); });
  }
  if (hierarchy_)
    hierarchy_->write([&](const std::filesystem::path &path) { write_merge(results.merged, path); });
}

void Outputs::write_report(const Report &report)
{
  if (report_)
    report_->write([&](const std::filesystem::path &path) { write_bytes(to_json(report), path); });
}

void Outputs::commit()
{
  for (auto &part : surfaces_)
    for (PendingOutput &output : part)
      output.commit();
  for (PendingOutput &output : vdb_volumes_)
    output.commit();
  for (auto *output : {&labels_, &report_, &hierarchy_})
    if (*output)
      (*output)->commit();
}

} // namespace volsurf
