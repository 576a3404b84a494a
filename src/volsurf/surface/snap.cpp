#include "volsurf/surface/snap.h"

#include "volsurf/core/vec3.h"
#include "volsurf/surface/cap_points.h"
#include "volsurf/surface/fairing.h"
#include "volsurf/surface/point_loop.h"
#include "volsurf/surface/point_stars.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

constexpr int kTakeBackPasses = 6; ///< moves are halved so often before they are given up

/// A way is dropped where it differs from the median of those around by so many times their median deviation, which
/// counts as at least this part of a voxel: so far apart smoothing leaves ways where nothing is wrong.
constexpr double kOutlierDeviations = 3;
constexpr double kUsualDeviationVoxels = 0.1;

/// What a deviation beyond that adds to the error. At 1 the crease between the study's blobs suffers; without it, thin
/// folds of brains become ragged.
constexpr double kErrorOfDeviation = 0.6;

/// How far off a point may be, in voxels of the scan's smallest spacing, where it did not find its edge and stands
/// where smoothing has put it.
constexpr double kErrorWithoutEdge = 0.5;

/// A triangle counts as turned over where its normal turns further than this.
constexpr double kLeastCosine = 0.1;

/// As long as twice the triangle's area.
Vec3 normal_of(const Triangle &t, const std::vector<Vec3> &positions)
{
  return cross(minus(positions[t[1]], positions[t[0]]), minus(positions[t[2]], positions[t[0]]));
}

double median(std::vector<double> &values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <typename Work> void for_each_point(const Mesh &mesh, Work work)
{
  volsurf::for_each_point(mesh.points.size(), [&](std::size_t point) { work(static_cast<PointId>(point)); });
}

/// Positions in millimetres along the axes of the grid, where the border planes are upright, whatever the grid's place
/// in the world.
std::vector<Vec3> positions_of(const Mesh &mesh, const Grid &grid)
{
  std::vector<Vec3> positions(mesh.points.size());
  for_each_point(mesh, [&](PointId point) {
    const Point &p = mesh.points[point];
    const Vec3 index = world_to_index(grid, {p[0], p[1], p[2]});
    for (int axis = 0; axis < 3; ++axis)
      positions[point][axis] = index[axis] * grid.spacing_mm[axis];
  });
  return positions;
}

void set_points(const std::vector<Vec3> &positions, const Grid &grid, Mesh &mesh)
{
  for_each_point(mesh, [&](PointId point) {
    Vec3 index = positions[point];
    for (int axis = 0; axis < 3; ++axis)
      index[axis] /= grid.spacing_mm[axis];
    const Vec3 world = index_to_world(grid, index);
    mesh.points[point] = {static_cast<float>(world[0]), static_cast<float>(world[1]), static_cast<float>(world[2])};
  });
}

/// The axes along which a point may move: a cap's points stay in its border plane.
using FreeAxes = std::array<bool, 3>;

std::vector<FreeAxes> find_free_axes(const Mesh &mesh, const Grid &grid)
{
  std::vector<FreeAxes> free_axes(mesh.points.size(), {true, true, true});
  for (const CapPoint &cap : find_cap_points(mesh, grid))
    free_axes[cap.point][static_cast<std::size_t>(cap.axis)] = false;
  return free_axes;
}

/// Where three or more triangles share an edge at the point.
bool is_on_junction(PointId point, const Mesh &mesh, const PointStars &stars, std::vector<PointId> &neighbours)
{
  neighbours.clear();
  stars.for_each(point, [&](std::size_t t) {
    for (const PointId other : mesh.triangles[t])
      if (other != point)
        neighbours.push_back(other);
  });
  std::sort(neighbours.begin(), neighbours.end());
  for (std::size_t i = 2; i < neighbours.size(); ++i)
    if (neighbours[i] == neighbours[i - 2])
      return true;
  return false;
}

/// 1 for the points on junctions.
std::vector<char> find_junctions(const Mesh &mesh, const PointStars &stars)
{
  std::vector<char> on_junction(mesh.points.size());
  for_each_point(mesh, [&](PointId point) {
    thread_local std::vector<PointId> neighbours;
    on_junction[point] = is_on_junction(point, mesh, stars, neighbours) ? 1 : 0;
  });
  return on_junction;
}

/// The mean normal of the walls at a point, within its free axes; nothing inside caps.
std::optional<Vec3> wall_normal(PointId point, const Mesh &mesh, const PointStars &stars,
                                const std::vector<Vec3> &positions, const FreeAxes &free_axes)
{
  Vec3 normal{0, 0, 0};
  stars.for_each(point, [&](std::size_t t) {
    if (mesh.cap[t] != 0)
      return;
    const Vec3 n = normal_of(mesh.triangles[t], positions);
    for (int axis = 0; axis < 3; ++axis)
      normal[axis] += free_axes[axis] ? n[axis] : 0;
  });
  const double size = length(normal);
  if (!(size > 0))
    return std::nullopt;
  return Vec3{normal[0] / size, normal[1] / size, normal[2] / size};
}

/// The size of the scan's voxels along a direction.
double voxel_mm(const Grid &grid, const Vec3 &direction)
{
  return grid.oversampling * std::hypot(direction[0] * grid.spacing_mm[0], direction[1] * grid.spacing_mm[1],
                                        direction[2] * grid.spacing_mm[2]);
}

/// A point's way to its edge.
struct Way {
  bool known = false;
  double length_mm = 0; ///< along `direction`
  double error_mm = 0;
  Vec3 direction{0, 0, 0};
  double voxel_mm = 0;
};

std::vector<Way> find_ways(const Mesh &mesh, const Grid &grid, const PointStars &stars,
                           const std::vector<Vec3> &positions, const std::vector<FreeAxes> &free_axes,
                           const std::vector<char> &on_junction, const FindEdge &find_edge)
{
  std::vector<Way> ways(mesh.points.size());
  for_each_point(mesh, [&](PointId point) {
    if (on_junction[point] != 0)
      return; // it has several normals
    const auto direction = wall_normal(point, mesh, stars, positions, free_axes[point]);
    if (!direction)
      return;
    Vec3 index = positions[point];
    for (int axis = 0; axis < 3; ++axis)
      index[axis] /= grid.spacing_mm[axis];
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

WaysAround measure_around(PointId point, const std::vector<Way> &ways, const Mesh &mesh, const PointStars &stars,
                          std::vector<double> &lengths)
{
  lengths.clear();
  stars.for_each(point, [&](std::size_t t) {
    for (const PointId other : mesh.triangles[t])
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
void judge_ways(const Mesh &mesh, const PointStars &stars, std::vector<Way> &ways)
{
  const std::vector<Way> all = ways;
  for_each_point(mesh, [&](PointId point) {
    thread_local std::vector<double> lengths;
    Way &way = ways[point];
    if (!way.known)
      return;
    const WaysAround around = measure_around(point, all, mesh, stars, lengths);
    const double usual_mm = kUsualDeviationVoxels * way.voxel_mm;
    const double deviation_mm = std::max(around.deviation_mm, usual_mm);
    way.known = std::abs(way.length_mm - around.median_mm) <= kOutlierDeviations * deviation_mm;
    way.error_mm = std::hypot(way.error_mm, kErrorOfDeviation * (deviation_mm - usual_mm));
  });
}

/// The error in mm of a known way, from those around: noise that moves an edge changes what it is thought to be off by,
/// so that single errors would favour edges on one side.
double error_around(PointId point, const std::vector<Way> &ways, const Mesh &mesh, const PointStars &stars)
{
  double squared = 0;
  int count = 0;
  stars.for_each(point, [&](std::size_t t) {
    for (const PointId other : mesh.triangles[t])
      if (ways[other].known) {
        squared += ways[other].error_mm * ways[other].error_mm;
        ++count;
      }
  });
  return std::sqrt(squared / count);
}

bool is_on_rim(PointId point, const Mesh &mesh, const PointStars &stars)
{
  bool on_cap = false;
  bool on_wall = false;
  stars.for_each(point, [&](std::size_t t) { (mesh.cap[t] != 0 ? on_cap : on_wall) = true; });
  return on_cap && on_wall;
}

/// What each point says of its place, in voxels of the grid.
std::vector<Target> make_targets(const Mesh &mesh, const Grid &grid, const PointStars &stars,
                                 const std::vector<Vec3> &positions, const std::vector<FreeAxes> &free_axes,
                                 const std::vector<char> &on_junction, const std::vector<Way> &ways, double least_error)
{
  const double voxel_mm = smallest_spacing_mm(grid);
  const double error_without_edge = grid.oversampling * kErrorWithoutEdge;
  std::vector<Target> targets(positions.size());
  for_each_point(mesh, [&](PointId point) {
    const Way &way = ways[point];
    Target &target = targets[point];
    target.position =
        scaled(1 / voxel_mm, way.known ? plus(positions[point], way.length_mm, way.direction) : positions[point]);
    target.error =
        way.known ? std::hypot(least_error, error_around(point, ways, mesh, stars) / voxel_mm) : error_without_edge;
    target.free_axes = free_axes[point];
    target.on_feature = on_junction[point] != 0 || is_on_rim(point, mesh, stars);
  });
  return targets;
}

/// A move in mm, cut off at the limit.
Vec3 within_limit(const Vec3 &move, const Grid &grid)
{
  const double size = length(move);
  if (size == 0)
    return move;
  const double limit = kSnapLimitVoxels * voxel_mm(grid, scaled(1 / size, move));
  return size > limit ? scaled(limit / size, move) : move;
}

/// How far each point moves, in mm: to its place on the fair surface.
std::vector<Vec3> fair_moves(const Mesh &mesh, const Grid &grid, const std::vector<Vec3> &positions,
                             const std::vector<Target> &targets)
{
  const double voxel = smallest_spacing_mm(grid);
  std::vector<Vec3> shape(positions.size());
  for_each_point(mesh, [&](PointId point) { shape[point] = scaled(1 / voxel, positions[point]); });
  std::vector<Vec3> moves = fair_positions(PointNeighbours(mesh), targets, shape, grid.oversampling);
  for_each_point(mesh, [&](PointId point) {
    moves[point] = within_limit(scaled(voxel, minus(moves[point], shape[point])), grid);
  });
  return moves;
}

std::vector<Vec3> moved(const std::vector<Vec3> &positions, const std::vector<Vec3> &moves)
{
  std::vector<Vec3> result = positions;
  for (std::size_t point = 0; point < result.size(); ++point)
    result[point] = plus(result[point], 1, moves[point]);
  return result;
}

/// The points of triangles that would turn over.
std::vector<char> find_overturned(const Mesh &mesh, const std::vector<Vec3> &before, const std::vector<Vec3> &after)
{
  std::vector<char> overturned(before.size());
  for (const Triangle &triangle : mesh.triangles) {
    const Vec3 a = normal_of(triangle, before);
    const Vec3 b = normal_of(triangle, after);
    if (dot(a, b) < kLeastCosine * std::sqrt(dot(a, a) * dot(b, b)))
      for (const PointId point : triangle)
        overturned[point] = 1;
  }
  return overturned;
}

/// Halves the moves around triangles that would turn over, in the end gives them up. Returns how many points stay.
std::int64_t take_back_overturns(const Mesh &mesh, const std::vector<Vec3> &positions, std::vector<Vec3> &moves)
{
  std::vector<char> given_up(positions.size());
  for (int pass = 0;; ++pass) {
    const std::vector<char> overturned = find_overturned(mesh, positions, moved(positions, moves));
    if (std::count(overturned.begin(), overturned.end(), 1) == 0)
      return std::count(given_up.begin(), given_up.end(), 1);
    for (std::size_t point = 0; point < positions.size(); ++point)
      if (overturned[point] != 0) {
        given_up[point] = pass >= kTakeBackPasses ? 1 : 0;
        for (double &part : moves[point])
          part = given_up[point] != 0 ? 0 : part / 2;
      }
  }
}

double root_mean_square(const std::vector<Vec3> &moves)
{
  double squared = 0;
  for (const Vec3 &move : moves)
    squared += dot(move, move);
  return moves.empty() ? 0 : std::sqrt(squared / static_cast<double>(moves.size()));
}

} // namespace

SnapResult snap_mesh(Mesh &mesh, const Grid &grid, const FindEdge &find_edge, double least_error)
{
  const PointStars stars(mesh);
  const std::vector<Vec3> positions = positions_of(mesh, grid);
  const std::vector<FreeAxes> free_axes = find_free_axes(mesh, grid);
  const std::vector<char> on_junction = find_junctions(mesh, stars);
  std::vector<Way> ways = find_ways(mesh, grid, stars, positions, free_axes, on_junction, find_edge);
  judge_ways(mesh, stars, ways);
  const auto targets = make_targets(mesh, grid, stars, positions, free_axes, on_junction, ways, least_error);
  std::vector<Vec3> moves = fair_moves(mesh, grid, positions, targets);

  SnapResult result;
  result.points = static_cast<std::int64_t>(mesh.points.size());
  result.moved = std::count_if(ways.begin(), ways.end(), [](const Way &way) { return way.known; });
  result.followed = result.points - result.moved;
  result.rejected = take_back_overturns(mesh, positions, moves);
  result.root_mean_square_mm = root_mean_square(moves);
  set_points(moved(positions, moves), grid, mesh);
  return result;
}

} // namespace volsurf
