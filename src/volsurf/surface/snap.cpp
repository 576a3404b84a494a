#include "volsurf/surface/snap.h"

#include "volsurf/surface/fairing.h"
#include "volsurf/surface/point_loop.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

/// A way is dropped where it differs from the median of those around by so many times their median deviation, which
/// counts as at least this part of a voxel: so far apart smoothing leaves ways where nothing is wrong.
constexpr double kOutlierDeviations = 3;
constexpr double kUsualDeviationVoxels = 0.1;

/// What a deviation beyond that adds to the error. At 1 the crease between the study's blobs suffers; without it, thin
/// folds of brains become ragged.
constexpr double kErrorOfDeviation = 0.6;

double median(std::vector<double> &values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A point's way to its edge.
struct Way {
  bool known = false;
  double length_mm = 0; ///< along `direction`
  double error_mm = 0;
  Vec3 direction{0, 0, 0};
  double voxel_mm = 0;
};

std::vector<Way> find_ways(const PlacementMesh &placement, const FindEdge &find_edge)
{
  const Grid &grid = placement.grid;
  std::vector<Way> ways(placement.positions.size());
  for_each_point(ways.size(), [&](std::size_t point) {
    const auto direction = placement.wall_normal(static_cast<PointId>(point), placement.positions);
    if (!direction)
      return;
    const Vec3 index = index_of_position(placement.positions[point], grid);
    const double voxel = voxel_mm(grid, *direction);
    if (const auto edge = find_edge(index, *direction, kSnapLimitVoxels * voxel))
      ways[point] = {true, edge->way_mm, edge->error_mm, *direction, voxel};
  });
  return ways;
}

/// The ways around a point, its own among them.
struct WaysAround {
  double median_mm = 0;
  double deviation_mm = 0; ///< the median deviation from it
};

WaysAround measure_around(PointId point, const std::vector<Way> &ways, const PlacementMesh &placement,
                          std::vector<double> &lengths)
{
  lengths.clear();
  placement.stars.for_each(point, [&](std::size_t t) {
    for (const PointId other : placement.mesh.triangles[t])
      if (ways[other].known)
        lengths.push_back(ways[other].length_mm);
  });
  WaysAround around;
  around.median_mm = median(lengths);
  for (double &length : lengths)
    length = std::abs(length - around.median_mm);
  around.deviation_mm = median(lengths);
  return around;
}

/// Drops what noise, impulses above all, takes for edges. Where ways differ more than smoothing leaves points off, they
/// are less certain than noise alone would have them: several edges are near, or none is clear.
void judge_ways(const PlacementMesh &placement, std::vector<Way> &ways)
{
  const std::vector<Way> all = ways;
  for_each_point(ways.size(), [&](std::size_t point) {
    thread_local std::vector<double> lengths;
    Way &way = ways[point];
    if (!way.known)
      return;
    const WaysAround around = measure_around(static_cast<PointId>(point), all, placement, lengths);
    const double usual_mm = kUsualDeviationVoxels * way.voxel_mm;
    const double deviation_mm = std::max(around.deviation_mm, usual_mm);
    way.known = std::abs(way.length_mm - around.median_mm) <= kOutlierDeviations * deviation_mm;
    way.error_mm = std::hypot(way.error_mm, kErrorOfDeviation * (deviation_mm - usual_mm));
  });
}

/// The error in mm of a known way, from those around: noise that moves an edge changes what it is thought to be off by,
/// so that single errors would favour edges on one side.
double error_around(PointId point, const std::vector<Way> &ways, const PlacementMesh &placement)
{
  double squared = 0;
  int count = 0;
  placement.stars.for_each(point, [&](std::size_t t) {
    for (const PointId other : placement.mesh.triangles[t])
      if (ways[other].known) {
        squared += ways[other].error_mm * ways[other].error_mm;
        ++count;
      }
  });
  return std::sqrt(squared / count);
}

/// What each point says of its place, in voxels of the grid.
std::vector<Target> make_targets(const PlacementMesh &placement, const std::vector<Way> &ways, double least_error)
{
  const double voxel_mm = smallest_spacing_mm(placement.grid);
  const double error_without_edge = placement.grid.oversampling * kErrorWithoutEdge;
  std::vector<Target> targets(ways.size());
  for_each_point(ways.size(), [&](std::size_t point) {
    const Way &way = ways[point];
    const Vec3 &position = placement.positions[point];
    Target &target = targets[point];
    target.position = scaled(1 / voxel_mm, way.known ? plus(position, way.length_mm, way.direction) : position);
    target.error = way.known
                       ? std::hypot(least_error, error_around(static_cast<PointId>(point), ways, placement) / voxel_mm)
                       : error_without_edge;
    target.free_axes = placement.free_axes[point];
    target.on_feature = placement.on_feature[point] != 0;
  });
  return targets;
}

} // namespace

PlacementResult snap_mesh(Mesh &mesh, const Grid &grid, const FindEdge &find_edge, double least_error)
{
  const PlacementMesh placement(mesh, grid);
  std::vector<Way> ways = find_ways(placement, find_edge);
  judge_ways(placement, ways);
  std::vector<char> known(ways.size());
  for_each_point(ways.size(), [&](std::size_t point) { known[point] = ways[point].known ? 1 : 0; });
  const auto places = fair_positions(placement.neighbours, make_targets(placement, ways, least_error),
                                     places_of(placement), sampling_of(grid));
  return move_points(placement, moves_to(places, kSnapLimitVoxels, placement), known, TurningOver::from_before, mesh);
}

} // namespace volsurf
