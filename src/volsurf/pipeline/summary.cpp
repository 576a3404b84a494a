#include "volsurf/pipeline/summary.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

namespace volsurf {

namespace {

constexpr std::size_t kMostListed = 20;

bool shrinks(const SurfaceSummary &surface)
{
  return surface.mesh.watertight && surface.volume_drift() < -kLargestShrinkage;
}

void warn_of_shrinkage(Report &report)
{
  const auto &surfaces = report.surfaces;
  const auto count = std::count_if(surfaces.begin(), surfaces.end(), shrinks);
  if (count == 0)
    return;
  const SurfaceSummary &worst = *std::max_element(surfaces.begin(), surfaces.end(), [](const auto &a, const auto &b) {
    return (shrinks(a) ? -a.volume_drift() : 0) < (shrinks(b) ? -b.volume_drift() : 0);
  });
  std::ostringstream warning;
  warning << "smoothing shrinks the enclosed volume ";
  if (report.settings.split != Split::none)
    warning << "of " << count << " of " << surfaces.size() << " surfaces, most of all that of number " << worst.number
            << ", ";
  warning << "by " << -100 * worst.volume_drift() << " %; try a smaller --smooth";
  report.warnings.push_back(warning.str());
}

} // namespace

void summarise_regions(const RegionMerge &merge, const Regions &regions, Report &report)
{
  const Hierarchy &hierarchy = merge.hierarchy;
  const Index3 &n = merge.cells.size;
  for (std::size_t rank = 0; rank < std::min(kMostListed, regions.count()); ++rank) {
    const BasinId basin = hierarchy.by_rank[rank];
    if (hierarchy.roots[basin] < 0)
      continue; // the exterior has no place
    const CellId root = hierarchy.roots[basin];
    const RegionId id = regions.of_basin[basin];
    const Index3 cell{root % n[0], root / n[0] % n[1], root / n[0] / n[1]};
    const Vec3 centre{static_cast<double>(cell[0]) + 0.5, static_cast<double>(cell[1]) + 0.5,
                      static_cast<double>(cell[2]) + 0.5};
    report.strongest_regions.push_back(
        {id, hierarchy.persistence[basin], regions.cell_counts[id - 1], index_to_world(report.grid, centre)});
  }
  report.basins = static_cast<std::int64_t>(hierarchy.basin_count());
  report.largest_persistence = hierarchy.largest_persistence();
  report.regions = static_cast<std::int64_t>(regions.count());
}

void add_components(const Components &components, Report &report)
{
  report.boundary_faces += static_cast<std::int64_t>(components.of_face.size());
  report.components += static_cast<std::int64_t>(components.count());
  report.components_kept += static_cast<std::int64_t>(components.kept);
  std::vector<double> &sizes = report.component_sizes;
  sizes.insert(sizes.end(), components.sizes.begin(),
               components.sizes.begin() + static_cast<std::ptrdiff_t>(std::min(components.kept, kMostListed)));
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  sizes.resize(std::min(sizes.size(), kMostListed));
}

void add_finishing(const Finishing &finishing, Report &report)
{
  report.smoothing = finishing.smoothing;
  if (!finishing.snap)
    return;
  const PlacementResult &one = *finishing.snap;
  PlacementResult all = report.snap.value_or(PlacementResult{});
  const auto sum_of_squares = [](const PlacementResult &result) {
    return static_cast<double>(result.points) * result.root_mean_square_mm * result.root_mean_square_mm;
  };
  const double squares = sum_of_squares(all) + sum_of_squares(one);
  all.points += one.points;
  all.moved += one.moved;
  all.followed += one.followed;
  all.rejected += one.rejected;
  all.root_mean_square_mm = all.points > 0 ? std::sqrt(squares / static_cast<double>(all.points)) : 0;
  report.snap = all;
}

void summarise_surfaces(Report &report)
{
  double volume_before_mm3 = 0;
  for (const SurfaceSummary &surface : report.surfaces) {
    report.mesh = report.mesh + surface.mesh;
    volume_before_mm3 += surface.volume_before_mm3;
  }
  const SurfaceSummary all{0, {}, report.mesh, volume_before_mm3};
  report.smoothing.volume_drift = all.volume_drift();
}

void collect_warnings(Report &report)
{
  if (report.non_finite_gradients > 0)
    report.warnings.push_back(std::to_string(report.non_finite_gradients) +
                              " samples have no finite gradient and were taken as walls");
  warn_of_shrinkage(report);
}

} // namespace volsurf
