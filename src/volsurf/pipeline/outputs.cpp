#include "volsurf/pipeline/outputs.h"

#include "volsurf/core/error.h"
#include "volsurf/interop/openvdb_grid.h"
#include "volsurf/io/write_mesh.h"
#include "volsurf/io/write_volume.h"
#include "volsurf/pipeline/stored_merge.h"

#include <algorithm>
#include <fstream>

namespace volsurf {

namespace {

bool is_vdb(const std::filesystem::path &path)
{
  return output_kind_of(path) == OutputKind::vdb;
}

LabelVolume region_labels(const Results &results)
{
  const Grid &grid = results.merged.input.volume.grid;
  LabelVolume labels{cell_centre_grid(grid), std::vector<std::uint32_t>(static_cast<std::size_t>(grid.cell_count()))};
  const auto &basins = results.merged.merge.cells.basins;
  std::transform(basins.begin(), basins.end(), labels.labels.begin(),
                 [&](BasinId basin) { return results.regions.of_basin[basin]; });
  return labels;
}

void write_text(const std::string &text, const std::filesystem::path &path)
{
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file)
    throw OutputError(path.string() + ": it could not be written; is the disk full?");
}

} // namespace

Outputs::Outputs(const Settings &settings) : settings_(settings)
{
  for (const auto &path : settings.outputs)
    surfaces_.emplace_back(path);
  if (settings.labels)
    labels_.emplace(*settings.labels);
  if (settings.report)
    report_.emplace(*settings.report);
  if (settings.hierarchy)
    hierarchy_.emplace(*settings.hierarchy);
}

void Outputs::write_results(const Results &results)
{
  const Provenance provenance{version_text(), source_name(results.merged), describe(settings_, results.delta)};
  LabelVolume labels;
  if (labels_ || std::any_of(settings_.outputs.begin(), settings_.outputs.end(), is_vdb))
    labels = region_labels(results);
  for (const PendingOutput &output : surfaces_)
    output.write([&](const std::filesystem::path &path) {
      if (is_vdb(output.target()))
        write_vdb(labels, gradient_magnitude(results.field, results.merged.input.volume.grid), path, provenance,
                  settings_.frame);
      else
        write_mesh(results.mesh, output_kind_of(output.target()), path, provenance, settings_.frame);
    });
  if (labels_)
    labels_->write([&](const std::filesystem::path &path) { write_labels(labels, path, provenance); });
  if (hierarchy_)
    hierarchy_->write([&](const std::filesystem::path &path) { write_merge(results.merged, path); });
}

void Outputs::write_report(const Report &report)
{
  if (report_)
    report_->write([&](const std::filesystem::path &path) { write_text(to_json(report), path); });
}

void Outputs::commit()
{
  for (PendingOutput &output : surfaces_)
    output.commit();
  for (auto *output : {&labels_, &report_, &hierarchy_})
    if (*output)
      (*output)->commit();
}

} // namespace volsurf
