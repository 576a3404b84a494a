#include "benchmark/volsurf_run.h"

#include "volsurf/surface/components.h"
#include "volsurf/surface/extract.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace volsurf::bench {

namespace {

Mesh mesh_of(FaceSet faces, const Components &components, const Grid &grid, const Sides &sides,
             const RegionMerge &merge, const Regions &regions, RegionId background)
{
  const RegionsOfCells regions_of_cells{merge.cells, regions.of_basin, background, merge.hierarchy.background,
                                        [&](BasinId a, BasinId b) { return saliency(merge.hierarchy, a, b); }};
  return extract_mesh(keep_components(std::move(faces), components), grid, sides, regions_of_cells, false);
}

constexpr std::int64_t kFree = -1;

/// An entry for each label.
std::vector<std::int64_t> free_names(const std::vector<std::uint32_t> &labels)
{
  return std::vector<std::int64_t>(*std::max_element(labels.begin(), labels.end()) + std::size_t{1}, kFree);
}

/// Whether two labellings differ by the names of the labels only.
bool same_partition(const std::vector<std::uint32_t> &left, const std::vector<std::uint32_t> &right)
{
  auto right_of = free_names(left);
  auto left_of = free_names(right);
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (right_of[left[i]] == kFree && left_of[right[i]] == kFree) {
      right_of[left[i]] = right[i];
      left_of[right[i]] = left[i];
    }
    if (right_of[left[i]] != right[i] || left_of[right[i]] != left[i])
      return false;
  }
  return true;
}

} // namespace

FieldOptions field_options(const RunOptions &options)
{
  return {options.sigma_mm, false};
}

Sides sides_of(const RegionMerge &merge, const Regions &regions)
{
  Sides sides{regions.of_basin, 0};
  std::replace(sides.of_basin.begin(), sides.of_basin.end(), regions.of_basin[merge.hierarchy.background], RegionId{0});
  return sides;
}

Outcome run_volsurf(const Volume &volume, const RunOptions &options, bool with_mesh)
{
  Outcome outcome;
  StageTimer timer;
  const EdgeField field(volume, field_options(options));
  const RegionMerge merge = merge_regions(volume.grid.size, field.planes(), {});
  timer.lap("gradient and merge");
  const Regions regions = cut(merge.hierarchy, options.delta);
  const Sides sides = sides_of(merge, regions);
  timer.lap("cut");
  FaceSet faces = find_boundary(merge.cells, sides);
  timer.lap("boundary");
  const Components components = find_components(faces, volume.grid, {});
  timer.lap("components");
  outcome.facts = {{"basins", merge.hierarchy.basin_count()},
                   {"largest_persistence", merge.hierarchy.largest_persistence()},
                   {"regions", regions.count()},
                   {"faces", faces.size()},
                   {"components", components.count()}};
  if (with_mesh) {
    const Mesh mesh = mesh_of(std::move(faces), components, volume.grid, sides, merge, regions,
                              regions.of_basin[merge.hierarchy.background]);
    timer.lap("mesh");
    outcome.facts["triangles"] = mesh.triangles.size();
  }
  outcome.seconds = timer.seconds();
  return outcome;
}

void require_volsurfs_regions(const Outcome &outcome, const Volume &volume, const RunOptions &options)
{
  const EdgeField field(volume, field_options(options));
  const RegionMerge merge = merge_regions(volume.grid.size, field.planes(), {});
  const Regions regions = cut(merge.hierarchy, options.delta);
  const auto found = outcome.facts.at("regions").get<std::size_t>();
  if (found != regions.count())
    throw std::runtime_error(std::to_string(found) + " regions, but volsurf finds " + std::to_string(regions.count()));
  if (outcome.region_of_cell.empty())
    return;
  std::vector<std::uint32_t> expected;
  expected.reserve(static_cast<std::size_t>(merge.cells.basins.size()));
  for (const BasinId basin : merge.cells.basins)
    expected.push_back(regions.of_basin[basin]);
  if (!same_partition(outcome.region_of_cell, expected))
    throw std::runtime_error("the regions are not volsurf's");
}

} // namespace volsurf::bench
