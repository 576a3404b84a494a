#include "volsurf/surface/snap.h"

#include "volsurf/core/parallel.h"
#include "volsurf/core/vec3.h"
#include "volsurf/surface/cap_points.h"
#include "volsurf/surface/point_stars.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

constexpr std::int64_t kPointsPerSlab = 4096;
constexpr int kFollowPasses = 8;   ///< how far, in edges, a point without a way looks for neighbours that have one
constexpr int kTakeBackPasses = 6; ///< moves are halved so often before they are given up

/// A way is dropped where it differs from the median of those around by so many times their median deviation, which
/// counts as at least this part of a voxel.
constexpr double kOutlierDeviations = 3;
constexpr double kLeastDeviationVoxels = 0.1;

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
  parallel_for_slabs(static_cast<std::int64_t>(mesh.points.size()), kPointsPerSlab, [&](const Slab &slab) {
    for (std::int64_t point = slab.begin; point < slab.end; ++point)
      work(static_cast<PointId>(point));
  });
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

/// A voxel's size along a direction.
double voxel_mm(const Grid &grid, const Vec3 &direction)
{
  return std::hypot(direction[0] * grid.spacing_mm[0], direction[1] * grid.spacing_mm[1],
                    direction[2] * grid.spacing_mm[2]);
}

/// A point's way to its edge.
struct Way {
  bool known = false;
  double length_mm = 0; ///< along `direction`
  Vec3 direction{0, 0, 0};
  double voxel_mm = 0;
};

std::vector<Way> find_ways(const Mesh &mesh, const Grid &grid, const PointStars &stars,
                           const std::vector<Vec3> &positions, const std::vector<FreeAxes> &free_axes,
                           const FindEdge &find_edge)
{
  std::vector<Way> ways(mesh.points.size());
  for_each_point(mesh, [&](PointId point) {
    thread_local std::vector<PointId> neighbours;
    if (is_on_junction(point, mesh, stars, neighbours))
      return; // it has several normals
    const auto direction = wall_normal(point, mesh, stars, positions, free_axes[point]);
    if (!direction)
      return;
    Vec3 index = positions[point];
    for (int axis = 0; axis < 3; ++axis)
      index[axis] /= grid.spacing_mm[axis];
    const double voxel = voxel_mm(grid, *direction);
    if (const auto length = find_edge(index, *direction, kSnapLimitVoxels * voxel))
      ways[point] = {true, *length, *direction, voxel};
  });
  return ways;
}

/// Noise, impulses above all, makes edges of its own.
bool is_outlier(PointId point, const std::vector<Way> &ways, const Mesh &mesh, const PointStars &stars,
                std::vector<double> &around)
{
  around.clear();
  stars.for_each(point, [&](std::size_t t) {
    for (const PointId other : mesh.triangles[t])
      if (ways[other].known)
        around.push_back(ways[other].length_mm);
  });
  const double middle = median(around);
  for (double &length : around)
    length = std::abs(length - middle);
  const double deviation = std::max(median(around), kLeastDeviationVoxels * ways[point].voxel_mm);
  return std::abs(ways[point].length_mm - middle) > kOutlierDeviations * deviation;
}

void drop_outliers(const Mesh &mesh, const PointStars &stars, std::vector<Way> &ways)
{
  const std::vector<Way> all = ways;
  for_each_point(mesh, [&](PointId point) {
    thread_local std::vector<double> around;
    if (all[point].known && is_outlier(point, all, mesh, stars, around))
      ways[point].known = false;
  });
}

/// How far each point moves.
struct Moves {
  std::vector<Vec3> of_point; ///< in mm
  std::vector<char> known;

  std::int64_t known_count() const { return std::count(known.begin(), known.end(), 1); }
};

Moves moves_along(const std::vector<Way> &ways)
{
  Moves moves{std::vector<Vec3>(ways.size()), std::vector<char>(ways.size())};
  for (std::size_t point = 0; point < ways.size(); ++point)
    if (ways[point].known) {
      for (int axis = 0; axis < 3; ++axis)
        moves.of_point[point][axis] = ways[point].length_mm * ways[point].direction[axis];
      moves.known[point] = 1;
    }
  return moves;
}

/// The mean of the neighbours' moves, within the point's free axes.
std::optional<Vec3> neighbours_move(PointId point, const Mesh &mesh, const PointStars &stars, const Moves &moves,
                                    const FreeAxes &free_axes)
{
  Vec3 sum{0, 0, 0};
  int count = 0;
  stars.for_each(point, [&](std::size_t t) {
    for (const PointId other : mesh.triangles[t])
      if (moves.known[other] != 0) {
        for (int axis = 0; axis < 3; ++axis)
          sum[axis] += moves.of_point[other][axis];
        ++count;
      }
  });
  if (count == 0)
    return std::nullopt;
  for (int axis = 0; axis < 3; ++axis)
    sum[axis] = free_axes[axis] ? sum[axis] / count : 0;
  return sum;
}

void follow_neighbours(const Mesh &mesh, const PointStars &stars, const std::vector<FreeAxes> &free_axes, Moves &moves)
{
  for (int pass = 0; pass < kFollowPasses; ++pass) {
    const Moves before = moves;
    for_each_point(mesh, [&](PointId point) {
      if (before.known[point] != 0)
        return;
      if (const auto move = neighbours_move(point, mesh, stars, before, free_axes[point])) {
        moves.of_point[point] = *move;
        moves.known[point] = 1;
      }
    });
  }
}

std::vector<Vec3> moved(const std::vector<Vec3> &positions, const Moves &moves)
{
  std::vector<Vec3> result = positions;
  for (std::size_t point = 0; point < result.size(); ++point)
    for (int axis = 0; axis < 3; ++axis)
      result[point][axis] += moves.of_point[point][axis];
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
std::int64_t take_back_overturns(const Mesh &mesh, const std::vector<Vec3> &positions, Moves &moves)
{
  std::vector<char> given_up(positions.size());
  for (int pass = 0;; ++pass) {
    const std::vector<char> overturned = find_overturned(mesh, positions, moved(positions, moves));
    if (std::count(overturned.begin(), overturned.end(), 1) == 0)
      return std::count(given_up.begin(), given_up.end(), 1);
    for (std::size_t point = 0; point < positions.size(); ++point)
      if (overturned[point] != 0) {
        given_up[point] = pass >= kTakeBackPasses ? 1 : 0;
        for (double &part : moves.of_point[point])
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

SnapResult snap_mesh(Mesh &mesh, const Grid &grid, const FindEdge &find_edge)
{
  const PointStars stars(mesh);
  const std::vector<Vec3> positions = positions_of(mesh, grid);
  const std::vector<FreeAxes> free_axes = find_free_axes(mesh, grid);
  std::vector<Way> ways = find_ways(mesh, grid, stars, positions, free_axes, find_edge);
  drop_outliers(mesh, stars, ways);

  SnapResult result;
  result.points = static_cast<std::int64_t>(mesh.points.size());
  Moves moves = moves_along(ways);
  result.moved = moves.known_count();
  follow_neighbours(mesh, stars, free_axes, moves);
  result.followed = moves.known_count() - result.moved;
  result.rejected = take_back_overturns(mesh, positions, moves);
  result.root_mean_square_mm = root_mean_square(moves.of_point);
  set_points(moved(positions, moves), grid, mesh);
  return result;
}

} // namespace volsurf
