// Meshes of other programs, made fit to be measured.
#pragma once

#include "volsurf/core/mesh.h"

#include <cstdint>

namespace volsurf {

/// The number of edges that triangles run through more often in one direction than in the other; 0 for a mesh that
/// encloses a volume. An edge of four triangles, where a surface touches itself, counts only if it does not cancel.
/// O(n log n).
std::int64_t count_unbalanced_edges(const Mesh &mesh);

/// Removes points that no triangle uses, and triangles without an area; the rest keeps its order. O(n).
void drop_unused(Mesh &mesh);

/// Makes one point of all that have the same coordinates: formats such as STL store each triangle's corners anew.
/// O(n log n).
void weld_points(Mesh &mesh);

} // namespace volsurf
