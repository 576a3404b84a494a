#include "volsurf/pipeline/surfaces.h"

#include "volsurf/core/error.h"
#include "volsurf/pipeline/summary.h"
#include "volsurf/surface/cell_box.h"
#include "volsurf/surface/extract.h"

#include <algorithm>

namespace volsurf {

namespace {

/// Cells, the grid of their corners, and what a surface there separates.
struct Separation {
  const CellLabels &cells;
  const Grid &grid;
  const Sides &sides;
  bool one_thing;
};

/// One run's stages up to the mesh, on all or on a part of its volume.
class SurfaceMaker {
public:
  SurfaceMaker(const CutVolume &volume, const Settings &settings, const SurfaceSink &sink)
      : volume_(volume), settings_(settings), sink_(sink)
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
    if (settings_.method != Method::volsurf)
      mesh.persistence.clear(); // only a hierarchy knows it
    sink_.timer.lap("surface");
    return mesh;
  }

private:
  const CutVolume &volume_;
  const Settings &settings_;
  const SurfaceSink &sink_;
};

/// All faces in one mesh.
void make_whole(const SurfaceMaker &maker, SurfaceWriter &writer, const Separation &whole)
{
  const KeptFaces faces = maker.find_kept_faces(whole);
  writer.expect_components();
  writer.write(maker.make_mesh(whole, faces));
}

/// The sides of one region against everything else.
void set_sides(RegionId region, const Regions &regions, Sides &sides)
{
  std::transform(regions.of_basin.begin(), regions.of_basin.end(), sides.of_basin.begin(),
                 [region](RegionId other) { return other == region ? region : kNoRegion; });
}

void make_regions(const SurfaceMaker &maker, SurfaceWriter &writer, const CutVolume &volume, const Selection &selection,
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
    const Grid grid = grid_in(boxes[part], volume.corners);
    set_sides(numbers[part], volume.regions, sides);
    const Separation separation{cells, grid, sides, true};
    writer.write_region(part, numbers[part], maker.make_mesh(separation, maker.find_kept_faces(separation)));
  }
}

/// The edge between samples is where the wall between volsurf's regions is; a usual method's surface stays as it is.
Finisher finisher_of(const CutVolume &volume, const Settings &settings)
{
  if (settings.method == Method::volsurf)
    return {volume.volume, volume.sigma_mm, settings};
  return {volume.corners, settings};
}

} // namespace

void make_surfaces(const CutVolume &volume, const Settings &settings, const Selection &selection,
                   const SurfaceSink &sink)
{
  const SurfaceMaker maker(volume, settings, sink);
  SurfaceWriter writer(finisher_of(volume, settings), settings, sink);
  if (settings.split == Split::regions)
    make_regions(maker, writer, volume, selection, sink);
  else
    make_whole(maker, writer, {volume.merge.cells, volume.corners, selection.sides, selection.one_thing});
  summarise_surfaces(sink.report);
}

} // namespace volsurf
