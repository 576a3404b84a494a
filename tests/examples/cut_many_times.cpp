// How to ask for many deltas: read and merge once, then cut as often as you like.
//
//   cut_many_times SCAN
//
// Prints what a handful of 1,000 deltas give, and extracts the surface at two of them.

#include "volsurf/pipeline/explore.h"
#include "volsurf/surface/extract.h"

#include <cstdio>

using namespace volsurf;

namespace {

/// One cut tells the regions and their sizes; the curve knows faces, area and components without it.
void print_delta(const RegionMerge &merge, const BoundaryCurve &curve, double delta)
{
  const Regions regions = cut(merge.hierarchy, delta);
  std::printf("delta %7.3f: %6zu regions, the largest has %lld cells; %8lld faces, %5lld components\n", delta,
              regions.count(), static_cast<long long>(regions.cell_counts.front()),
              static_cast<long long>(curve.faces_at(delta)), static_cast<long long>(curve.components_at(delta)));
}

/// From the merge to a mesh: nothing of it looks at the scan again.
Mesh surface_at(const RegionMerge &merge, const Grid &grid, double delta)
{
  const Regions regions = cut(merge.hierarchy, delta);
  const RegionId background = regions.of_basin[merge.hierarchy.background];
  const Sides each_region{regions.of_basin, background};
  FaceSet faces = find_boundary(merge.cells, each_region);
  const Components components = find_components(faces, grid, {});
  const RegionsOfCells regions_of_cells{merge.cells, regions.of_basin, background, merge.hierarchy.background,
                                        [&](BasinId a, BasinId b) { return saliency(merge.hierarchy, a, b); }};
  return extract_mesh(keep_components(std::move(faces), components), grid, each_region, regions_of_cells, false);
}

void cut_many_times(const char *scan)
{
  Settings settings;
  settings.input = scan;
  MergedVolume volume = read_input(settings);
  merge_input(volume);
  const RegionMerge &merge = volume.merge;
  const Grid &grid = volume.input.volume.grid;
  const BoundaryCurve curve = boundary_curve(merge, grid);

  constexpr int kDeltas = 1000;
  std::size_t regions = 0;
  for (int i = 1; i <= kDeltas; ++i) {
    const double delta = merge.hierarchy.largest_persistence() * i / kDeltas;
    regions += cut(merge.hierarchy, delta).count();
    if (i % (kDeltas / 5) == 0)
      print_delta(merge, curve, delta);
  }
  std::printf("%zu regions over %d deltas\n", regions, kDeltas);

  for (const double delta : {10.0, 40.0}) {
    const Mesh mesh = surface_at(merge, grid, delta);
    std::printf("surface at delta %g: %zu triangles\n", delta, mesh.triangles.size());
  }
}

} // namespace

int main(int argc, char **argv)
{
  if (argc != 2) {
    std::fprintf(stderr, "usage: cut_many_times SCAN\n");
    return 2;
  }
  try {
    cut_many_times(argv[1]);
    return 0;
  } catch (const Error &error) {
    std::fprintf(stderr, "cut_many_times: %s\n", error.what());
    return 1;
  }
}
