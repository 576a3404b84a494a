// The connected components of any triangle mesh, for meshes that do not come from a set of faces.
#pragma once

#include "volsurf/core/mesh.h"
#include "volsurf/surface/components.h"

namespace volsurf {

/// Triangles are connected over shared points; what RankBy calls faces are triangles. Ties go to the lowest triangle.
/// O(triangles).
Components find_components(const Mesh &mesh, const ComponentOptions &options);

/// The triangles of the kept components, each with its component, in the order of the mesh.
Mesh keep_components(const Mesh &mesh, const Components &components);

} // namespace volsurf
