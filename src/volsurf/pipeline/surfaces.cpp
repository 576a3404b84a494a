#include "volsurf/pipeline/surfaces.h"

#include "volsurf/core/error.h"
#include "volsurf/pipeline/finishing.h"
#include "volsurf/pipeline/summary.h"
#include "volsurf/surface/cell_box.h"
#include "volsurf/surface/extract.h"
#include "volsurf/surface/mesh_parts.h"

#include <algorithm>
#include <numeric>

namespace volsurf {

namespace {

/// Cells, the grid of their corners, and what a surface there separates.
struct Separation {
  const CellLabels &cells;
  const Grid &grid;
  const Sides &sides;
  bool one_thing;
};

/// One run's stages, on all or on a part of its volume.
class SurfaceMaker {
public:
  SurfaceMaker(const CutVolume &volume, const Settings &settings, const SurfaceSink &sink)
      : volume_(volume), settings_(settings), sink_(sink), finisher_(volume.volume, volume.sigma_mm, settings)
  {
  }

  KeptFaces find_kept_faces(const Separation &separation) const
  {
    report_progress(sink_.progress, "boundary", 0);
    FaceSet faces = find_boundary(separation.cells, separation.sides);
    sink_.timer.lap("boundary");
    report_progress(sink_.progress, "components", 0);
    const Components components = find_components(faces, separation.grid, settings_.components);
    add_components(components, sink_.report);
    KeptFaces kept = keep_components(std::move(faces), components);
    sink_.timer.lap("components");
    return kept;
  }

  Mesh make_mesh(const Separation &separation, const KeptFaces &faces) const
  {
    report_progress(sink_.progress, "surface", 0);
    const Hierarchy &hierarchy = volume_.merge.hierarchy;
    const RegionsOfCells regions{separation.cells, volume_.regions.of_basin, volume_.background, hierarchy.background,
                                 [&](BasinId a, BasinId b) { return saliency(hierarchy, a, b); }};
    Mesh mesh = extract_mesh(faces, separation.grid, separation.sides, regions, separation.one_thing);
    sink_.timer.lap("surface");
    return mesh;
  }

  void smooth(Mesh &mesh) const
  {
    report_progress(sink_.progress, "smooth", 0);
    add_finishing(finisher_.finish(mesh), sink_.report);
    sink_.timer.lap("smooth");
  }

  /// Checks and writes the surface of the `part`-th region or component, which has this number.
  void finish(std::size_t part, std::uint32_t number, const Mesh &mesh, double volume_before_mm3) const
  {
    const MeshCheck check = check_mesh(mesh);
    sink_.timer.lap("check");
    report_progress(sink_.progress, "write", 0);
    const auto files = sink_.outputs.write_surface(part, mesh, sink_.provenance);
    sink_.report.surfaces.push_back({number, files, check, volume_before_mm3});
    sink_.timer.lap("write");
  }

private:
  const CutVolume &volume_;
  const Settings &settings_;
  const SurfaceSink &sink_;
  Finisher finisher_;
};

void make_whole(const SurfaceMaker &maker, const Separation &whole)
{
  Mesh mesh = maker.make_mesh(whole, maker.find_kept_faces(whole));
  const double volume_before_mm3 = signed_volume_mm3(mesh);
  maker.smooth(mesh);
  maker.finish(0, 0, mesh, volume_before_mm3);
}

void make_components(const SurfaceMaker &maker, const Separation &whole, const SurfaceSink &sink)
{
  const KeptFaces faces = maker.find_kept_faces(whole);
  const auto count = static_cast<std::size_t>(sink.report.components_kept);
  std::vector<ComponentId> numbers(count);
  std::iota(numbers.begin(), numbers.end(), ComponentId{1});
  sink.outputs.expect_parts(numbers);

  Mesh mesh = maker.make_mesh(whole, faces);
  const std::vector<double> volumes_before_mm3 = volumes_by_component_mm3(mesh, count);
  maker.smooth(mesh);
  const std::vector<TriangleList> triangles = triangles_by_component(mesh, count);
  for (std::size_t part = 0; part < count; ++part)
    maker.finish(part, numbers[part], take_triangles(mesh, triangles[part]), volumes_before_mm3[part]);
}

/// The sides of one region against everything else.
void set_sides(RegionId region, const Regions &regions, Sides &sides)
{
  std::transform(regions.of_basin.begin(), regions.of_basin.end(), sides.of_basin.begin(),
                 [region](RegionId other) { return other == region ? region : kNoRegion; });
}

void make_regions(const SurfaceMaker &maker, const CutVolume &volume, const Selection &selection,
                  const SurfaceSink &sink)
{
  const std::vector<RegionId> &numbers = selection.regions;
  if (std::binary_search(numbers.begin(), numbers.end(), volume.background))
    throw UsageError("--split regions: found region " + std::to_string(volume.background) +
                     ", the background, which has no closed surface; allowed are the other regions");
  sink.outputs.expect_parts(numbers);

  const auto boxes = boxes_around(volume.merge.cells, volume.regions.of_basin, numbers);
  Sides sides{volume.regions.of_basin, kNoRegion};
  for (std::size_t part = 0; part < numbers.size(); ++part) {
    const CellLabels cells = cells_in(boxes[part], volume.merge.cells);
    const Grid grid = grid_in(boxes[part], volume.volume.grid);
    set_sides(numbers[part], volume.regions, sides);
    const Separation separation{cells, grid, sides, true};
    Mesh mesh = maker.make_mesh(separation, maker.find_kept_faces(separation));
    const double volume_before_mm3 = signed_volume_mm3(mesh);
    maker.smooth(mesh);
    maker.finish(part, numbers[part], mesh, volume_before_mm3);
  }
}

} // namespace

void make_surfaces(const CutVolume &volume, const Settings &settings, const Selection &selection,
                   const SurfaceSink &sink)
{
  const SurfaceMaker maker(volume, settings, sink);
  const Separation whole{volume.merge.cells, volume.volume.grid, selection.sides, selection.one_thing};
  switch (settings.split) {
  case Split::none:
    make_whole(maker, whole);
    break;
  case Split::components:
    make_components(maker, whole, sink);
    break;
  case Split::regions:
    make_regions(maker, volume, selection, sink);
    break;
  }
  summarise_surfaces(sink.report);
}

} // namespace volsurf
