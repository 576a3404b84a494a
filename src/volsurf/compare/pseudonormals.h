// Normals of a mesh's faces, edges and corners, which tell the side of a point by the feature nearest to it.
#pragma once

#include "volsurf/core/mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace volsurf {

/// What of a triangle is nearest to a point: its corner i, its side from corner i to the next, or its inside.
enum class Feature : std::uint8_t { corner0, corner1, corner2, side0, side1, side2, face };
constexpr std::size_t kFeatures = 7;

/// For each triangle, the outward direction at each of its features; not of unit length.
using Pseudonormals = std::vector<std::array<Point, kFeatures>>;

/// Face normals; at a side the sum of the two triangles' normals; at a corner the sum over its triangles weighted by
/// their angles (J. A. Baerentzen and H. Aanaes, "Signed distance computation using the angle weighted pseudonormal",
/// IEEE TVCG 11, 2005). Where more than two triangles meet at an edge, as where a surface touches itself, no triangle
/// is joined over it, so that each sheet counts for itself. O(n log n).
Pseudonormals find_pseudonormals(const Mesh &mesh);

} // namespace volsurf
