#include "volsurf/surface/placement.h"

#include "volsurf/surface/cap_points.h"
#include "volsurf/surface/point_loop.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

/// Moves of a triangle are halved so often, then so often those around it as well, before they are given up.
constexpr int kTakeBackPasses = 4;

/// A triangle counts as turned over where its normal turns further than this.
constexpr double kLeastCosine = 0.1;

/// As long as twice the triangle's area.
Vec3 normal_of(const Triangle &t, const std::vector<Vec3> &positions)
{
  return cross(minus(positions[t[1]], positions[t[0]]), minus(positions[t[2]], positions[t[0]]));
}

std::vector<Vec3> positions_of(const Mesh &mesh, const Grid &grid)
{
  std::vector<Vec3> positions(mesh.points.size());
  for_each_point(mesh.points.size(), [&](std::size_t point) {
    const Vec3 index = world_to_index(grid, to_vec3(mesh.points[point]));
    for (int axis = 0; axis < 3; ++axis)
      positions[point][axis] = index[axis] * grid.spacing_mm[axis];
  });
  return positions;
}

std::vector<FreeAxes> find_free_axes(const Mesh &mesh, const Grid &grid)
{
  std::vector<FreeAxes> free_axes(mesh.points.size(), {true, true, true});
  for (const CapPoint &cap : find_cap_points(mesh, grid))
    free_axes[cap.point][static_cast<std::size_t>(cap.axis)] = false;
  return free_axes;
}

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

bool is_on_rim(PointId point, const Mesh &mesh, const PointStars &stars)
{
  bool on_cap = false;
  bool on_wall = false;
  stars.for_each(point, [&](std::size_t t) { (mesh.cap[t] != 0 ? on_cap : on_wall) = true; });
  return on_cap && on_wall;
}

std::vector<Vec3> moved(const std::vector<Vec3> &positions, const std::vector<Vec3> &moves)
{
  std::vector<Vec3> result = positions;
  for (std::size_t point = 0; point < result.size(); ++point)
    result[point] = plus(result[point], 1, moves[point]);
  return result;
}

bool points_away(const Vec3 &a, const Vec3 &b)
{
  return dot(a, b) < kLeastCosine * std::sqrt(dot(a, a) * dot(b, b));
}

/// Whether each triangle's normal points away from those of the triangles around it.
std::vector<char> find_folded(const Mesh &mesh, const PointStars &stars, const std::vector<Vec3> &positions)
{
  std::vector<Vec3> around(positions.size(), Vec3{0, 0, 0});
  for_each_point(positions.size(), [&](std::size_t point) {
    stars.for_each(static_cast<PointId>(point), [&](std::size_t t) {
      around[point] = plus(around[point], 1, normal_of(mesh.triangles[t], positions));
    });
  });
  std::vector<char> folded(mesh.triangles.size());
  for_each_point(folded.size(), [&](std::size_t t) {
    const auto &[a, b, c] = mesh.triangles[t];
    const Vec3 n = normal_of(mesh.triangles[t], positions);
    const Vec3 mean = plus(plus(around[a], 1, around[b]), 1, around[c]);
    folded[t] = points_away(n, mean) ? 1 : 0;
  });
  return folded;
}

/// Tells which triangles would turn over.
class TurnedOver {
public:
  TurnedOver(const PlacementMesh &placement, TurningOver rule) : placement_(placement), rule_(rule)
  {
    if (rule == TurningOver::from_those_around)
      folded_before_ = find_folded(placement.mesh, placement.stars, placement.positions);
  }

  /// 1 for those, with their points at `places`.
  std::vector<char> find(const std::vector<Vec3> &places) const
  {
    const std::vector<Triangle> &triangles = placement_.mesh.triangles;
    if (rule_ == TurningOver::from_those_around) {
      std::vector<char> turned = find_folded(placement_.mesh, placement_.stars, places);
      for_each_point(turned.size(),
                     [&](std::size_t t) { turned[t] = turned[t] != 0 && folded_before_[t] == 0 ? 1 : 0; });
      return turned;
    }
    std::vector<char> turned(triangles.size());
    for_each_point(turned.size(), [&](std::size_t t) {
      turned[t] = points_away(normal_of(triangles[t], placement_.positions), normal_of(triangles[t], places)) ? 1 : 0;
    });
    return turned;
  }

private:
  const PlacementMesh &placement_;
  TurningOver rule_;
  std::vector<char> folded_before_;
};

/// The points of triangles that turn over; with `around`, of the triangles at these, too, which decide with them.
std::vector<char> points_of(const std::vector<char> &turned, const PlacementMesh &placement, bool around)
{
  const std::vector<Triangle> &triangles = placement.mesh.triangles;
  std::vector<char> points(placement.positions.size());
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (turned[t] == 0)
      continue;
    for (const PointId point : triangles[t]) {
      points[point] = 1;
      if (around)
        placement.stars.for_each(point, [&](std::size_t other) {
          for (const PointId neighbour : triangles[other])
            points[neighbour] = 1;
        });
    }
  }
  return points;
}

/// Halves the moves around triangles that would turn over, in the end gives them up. Returns how many points stay.
std::int64_t take_back_overturns(const PlacementMesh &placement, TurningOver rule, std::vector<Vec3> &moves)
{
  const TurnedOver turned_over(placement, rule);
  std::vector<char> given_up(moves.size());
  for (int pass = 0;; ++pass) {
    const bool around = pass >= kTakeBackPasses;
    const bool give_up = pass >= 2 * kTakeBackPasses;
    const auto points = points_of(turned_over.find(moved(placement.positions, moves)), placement, around);
    if (std::count(points.begin(), points.end(), 1) == 0)
      return std::count(given_up.begin(), given_up.end(), 1);
    for (std::size_t point = 0; point < moves.size(); ++point)
      if (points[point] != 0) {
        given_up[point] = give_up ? 1 : 0;
        moves[point] = scaled(give_up ? 0 : 0.5, moves[point]);
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

/// A move in mm, cut off where it is longer than so many voxels of the scan along it.
Vec3 within_limit(const Vec3 &move, double limit_voxels, const Grid &grid)
{
  const double size = length(move);
  if (size == 0)
    return move;
  const double limit = limit_voxels * voxel_mm(grid, scaled(1 / size, move));
  return size > limit ? scaled(limit / size, move) : move;
}

} // namespace

PlacementMesh::PlacementMesh(const Mesh &m, const Grid &g)
    : mesh(m), grid(g), stars(m), neighbours(m), positions(positions_of(m, g)), free_axes(find_free_axes(m, g)),
      on_junction(m.points.size()), on_feature(m.points.size())
{
  for_each_point(positions.size(), [&](std::size_t i) {
    thread_local std::vector<PointId> scratch;
    const auto point = static_cast<PointId>(i);
    on_junction[i] = is_on_junction(point, mesh, stars, scratch) ? 1 : 0;
    on_feature[i] = on_junction[i] != 0 || is_on_rim(point, mesh, stars) ? 1 : 0;
  });
}

std::optional<Vec3> PlacementMesh::wall_normal(PointId point, const std::vector<Vec3> &places) const
{
  if (on_junction[point] != 0)
    return std::nullopt;
  Vec3 normal{0, 0, 0};
  stars.for_each(point, [&](std::size_t t) {
    if (mesh.cap[t] != 0)
      return;
    const Vec3 n = normal_of(mesh.triangles[t], places);
    for (int axis = 0; axis < 3; ++axis)
      normal[axis] += free_axes[point][axis] ? n[axis] : 0;
  });
  const double size = length(normal);
  if (!(size > 0))
    return std::nullopt;
  return Vec3{normal[0] / size, normal[1] / size, normal[2] / size};
}

double voxel_mm(const Grid &grid, const Vec3 &direction)
{
  return grid.oversampling * std::hypot(direction[0] * grid.spacing_mm[0], direction[1] * grid.spacing_mm[1],
                                        direction[2] * grid.spacing_mm[2]);
}

Vec3 index_of_position(const Vec3 &position_mm, const Grid &grid)
{
  return {position_mm[0] / grid.spacing_mm[0], position_mm[1] / grid.spacing_mm[1],
          position_mm[2] / grid.spacing_mm[2]};
}

Point point_of_position(const Vec3 &position_mm, const Grid &grid)
{
  const Vec3 world = index_to_world(grid, index_of_position(position_mm, grid));
  return {static_cast<float>(world[0]), static_cast<float>(world[1]), static_cast<float>(world[2])};
}

std::vector<Vec3> places_of(const PlacementMesh &placement)
{
  const double unit_mm = smallest_spacing_mm(placement.grid);
  std::vector<Vec3> places(placement.positions.size());
  for_each_point(places.size(), [&](std::size_t i) { places[i] = scaled(1 / unit_mm, placement.positions[i]); });
  return places;
}

std::vector<Vec3> moves_to(const std::vector<Vec3> &places, double limit_voxels, const PlacementMesh &placement)
{
  const double unit_mm = smallest_spacing_mm(placement.grid);
  std::vector<Vec3> moves = places_of(placement);
  for_each_point(moves.size(), [&](std::size_t i) {
    moves[i] = within_limit(scaled(unit_mm, minus(places[i], moves[i])), limit_voxels, placement.grid);
  });
  return moves;
}

PlacementResult move_points(const PlacementMesh &placement, std::vector<Vec3> moves, const std::vector<char> &known,
                            TurningOver rule, Mesh &mesh)
{
  PlacementResult result;
  result.points = static_cast<std::int64_t>(moves.size());
  result.moved = std::count(known.begin(), known.end(), 1);
  result.followed = result.points - result.moved;
  result.rejected = take_back_overturns(placement, rule, moves);
  result.root_mean_square_mm = root_mean_square(moves);
  for_each_point(moves.size(), [&](std::size_t point) {
    mesh.points[point] = point_of_position(plus(placement.positions[point], 1, moves[point]), placement.grid);
  });
  return result;
}

} // namespace volsurf
