// A fair surface through uncertain points: each as near to where it should be as that is certain, and the whole bent
// from point to point no more sharply than surfaces are.
//
// In: the neighbours of a mesh's points; where each should be, and how far off that may be; a surface whose bends are
// about right. Out: the places x that minimise
//
//     sum |x_i - target_i|^2 / error_i^2  +  sum |bend_i(x) - expected bend_i|^2 / bend_sd^2,
//
// bend_i(x) being the mean of the neighbours of i less x_i: the smoothing spline of a mesh. How much bends differ from
// what is expected, the given surface tells. A point with a small error stays at its target whatever its neighbours
// say; one that knows nothing goes where the surface bends least. Where the surface bends much more sharply than
// expected all the same, it has a crease, and is solved again with bends that cost less there. On features (junctions,
// the rims of caps) only the two neighbours along them count. In the end the points are moved from the surface to where
// flat triangles between them are on it, on average, so that no volume is lost.
//
// Guarantees: no thread count changes a byte. Passes: the expected bends, those of the given surface averaged over
// neighbours; then conjugate gradients, whose sums are taken slab by slab, once and once more for each look at creases.
//
// Source: Kobbelt, Campagna, Vorsatz, Seidel, "Interactive multi-resolution modeling on arbitrary meshes", SIGGRAPH
// 1998 (the thin plate of a mesh); Huber, "Robust statistics" (1981), chapter 7 (least squares solved again, for
// creases).
#pragma once

#include "volsurf/core/grid.h"
#include "volsurf/surface/point_neighbours.h"

#include <functional>

namespace volsurf {

/// Where a point should be. Lengths are in voxels, the smallest spacing.
struct Target {
  Vec3 position{};
  double error = 1;                                ///< its sd, above 0
  std::array<bool, 3> free_axes{true, true, true}; ///< along the others it stays where it is
  bool on_feature = false;
};

/// How the points of a mesh lie.
struct MeshSampling {
  int oversampling = 1; ///< of its grid against the scan's: what reaches over some points of a surface of the scan's
                        ///< own grid reaches over so many times as many
  bool is_even = true;  ///< about as dense along all axes; else bends tell of the triangles, not of the surface
};

/// Of a mesh made on a grid.
MeshSampling sampling_of(const Grid &grid);

/// The least sd of a bend, of a surface on the scan's own grid; on a finer one surfaces bend so many times less from
/// point to point. The study's balls, tubes, creases and thin shells decided: 0.02 is best with strong noise, and what
/// 0.05 wins without noise is less than 0.01 voxel.
constexpr double kLeastBend = 0.02;

/// The sd of a bend as a multiple of what bends of the given surface are off from their average, in the median, where
/// its points lie evenly: folded surfaces bend as they like where others must not. 2 leaves the study's cortex further
/// off with strong noise, 4 its tubes.
constexpr double kBendOfDeviation = 3;

/// What bends as much is a staircase that was not smoothed, which tells nothing of the surface to come.
constexpr double kBendOfStaircase = 0.1;

/// `shape` holds the points of the given surface. O(points): each is visited about 100 times, on a finer grid 400
/// times. Parallel.
std::vector<Vec3> fair_positions(const PointNeighbours &neighbours, const std::vector<Target> &targets,
                                 const std::vector<Vec3> &shape, const MeshSampling &sampling = {});

/// What each point says of its place when the points are at `places`.
using FindTargets = std::function<std::vector<Target>(const std::vector<Vec3> &places)>;

/// The same where targets depend on the places of all points: they are asked for `rounds` times, each time at the
/// places found with the last ones, at first at `shape`. They stand for the triangles as they are, flat, so that points
/// are not moved in the end. Axes and features stay what they are at first.
std::vector<Vec3> fair_positions(const PointNeighbours &neighbours, const FindTargets &find_targets, int rounds,
                                 const std::vector<Vec3> &shape, const MeshSampling &sampling = {});

} // namespace volsurf
