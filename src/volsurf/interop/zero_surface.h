// The surface where a volume is 0.
#pragma once

#include "volsurf/core/mesh.h"
#include "volsurf/core/volume.h"

namespace volsurf {

/// The isosurface of value 0 by VTK's FlyingEdges3D, in LPS; normals point to positive values. Of a signed distance it
/// is the body's surface: closed where the volume's border is positive. Without the arrays of a mesh.
Mesh zero_surface(const Volume &volume);

} // namespace volsurf
