// What moving the points of a surface to where they belong needs to know of its mesh, whichever way they are found.
#pragma once

#include "volsurf/core/vec3.h"
#include "volsurf/surface/point_neighbours.h"
#include "volsurf/surface/point_stars.h"

#include <optional>

namespace volsurf {

/// The furthest move of a point, in voxels of the scan along it: so far a smoothed staircase is off at most.
constexpr double kSnapLimitVoxels = 1.5;

/// How far off a point may be, in voxels of the scan's smallest spacing, where nothing is known of its edge and it
/// stands where smoothing has put it.
constexpr double kErrorWithoutEdge = 0.5;

/// The axes along which a point may move: a cap's points stay in its border plane.
using FreeAxes = std::array<bool, 3>;

struct PlacementResult {
  std::int64_t points = 0;        ///< all of them
  std::int64_t moved = 0;         ///< points that found their edge
  std::int64_t followed = 0;      ///< points that found none, or lie on a junction, and went with their neighbours
  std::int64_t rejected = 0;      ///< points that stayed, since a triangle would have turned over
  double root_mean_square_mm = 0; ///< of the ways of all points
};

/// A mesh that is to be placed, and what is known of its points before.
struct PlacementMesh {
  /// Keeps references to both. O(points + triangles).
  PlacementMesh(const Mesh &mesh, const Grid &grid);

  /// The mean normal of the walls at a point, within its free axes, for points at `places`; nothing inside caps and on
  /// junctions, which have several.
  std::optional<Vec3> wall_normal(PointId point, const std::vector<Vec3> &places) const;

  const Mesh &mesh;
  const Grid &grid;
  PointStars stars;
  PointNeighbours neighbours;
  /// In millimetres along the axes of the grid, where the border planes are upright, whatever its place in the world.
  std::vector<Vec3> positions;
  std::vector<FreeAxes> free_axes;
  std::vector<char> on_junction; ///< 1 where three or more triangles share an edge at the point
  std::vector<char> on_feature;  ///< 1 on junctions and on the rims of caps
};

/// The fractional index of a position in mm along the axes of the grid, and its point in the world.
Vec3 index_of_position(const Vec3 &position_mm, const Grid &grid);
Point point_of_position(const Vec3 &position_mm, const Grid &grid);

/// The positions in units of the grid's smallest spacing, as fairing takes them.
std::vector<Vec3> places_of(const PlacementMesh &placement);

/// The moves in mm from the positions to such places, cut off where they are longer than so many voxels of the scan.
std::vector<Vec3> moves_to(const std::vector<Vec3> &places, double limit_voxels, const PlacementMesh &placement);

/// The size of the scan's voxels along a direction of unit length.
double voxel_mm(const Grid &grid, const Vec3 &direction);

/// What a triangle's normal must not point away from.
enum class TurningOver {
  from_before,       ///< what it was
  from_those_around, ///< the triangles around it, which may all turn together: at the foot of a furrow that opens
};

/// Moves the points, in mm along the axes of the grid. Moves that would turn a triangle over are halved until they do
/// not, in the end given up. `known` holds 1 for points that found their edge.
PlacementResult move_points(const PlacementMesh &placement, std::vector<Vec3> moves, const std::vector<char> &known,
                            TurningOver rule, Mesh &mesh);

} // namespace volsurf
