// How the surface is found: volsurf's own way, or a usual one to compare it with.
#pragma once

#include <string>

namespace volsurf {

enum class Method {
  volsurf,        ///< between regions, merged by persistence
  threshold,      ///< around the voxels whose samples are at least an iso-value
  isosurface,     ///< where the interpolated volume has an iso-value, by flying edges
  marching_cubes, ///< the same by marching cubes
  cgal_mesher,    ///< the same by CGAL's surface mesher
  watershed,      ///< between the voxels of flooded basins, filled up to delta
};

/// "volsurf", "threshold", "isosurface", "marching-cubes", "cgal-mesher" or "watershed".
std::string method_text(Method method);

/// Whether an iso-value decides, and not delta.
bool takes_iso_value(Method method);

/// Whether the surface is one of regions, made of faces.
bool finds_regions(Method method);

struct Settings;

/// Throws UsageError where settings hold options that mean nothing to their method, or this program lacks the method.
void check_method(const Settings &settings);

} // namespace volsurf
