// A mesh, component by component.
#pragma once

#include "volsurf/core/mesh.h"

#include <vector>

namespace volsurf {

using TriangleList = std::vector<std::size_t>; ///< indices of triangles, ascending

/// The triangles of components 1 .. components, each in the order of the mesh. O(triangles).
std::vector<TriangleList> triangles_by_component(const Mesh &mesh, std::size_t components);

/// The signed volume of each component, in mm^3; has a meaning for closed ones only. O(triangles).
std::vector<double> volumes_by_component_mm3(const Mesh &mesh, std::size_t components);

/// A mesh of some triangles, as they are, with the points that they use and the arrays that there are, in the order of
/// the mesh.
Mesh take_triangles(const Mesh &mesh, const TriangleList &triangles);

} // namespace volsurf
