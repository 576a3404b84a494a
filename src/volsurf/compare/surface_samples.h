// Points spread over a surface, each standing for a piece of its area.
#pragma once

#include "volsurf/core/grid.h"
#include "volsurf/core/mesh.h"

#include <cstdint>
#include <vector>

namespace volsurf {

struct SurfaceSamples {
  std::vector<Vec3> positions;   ///< in mm
  std::vector<double> areas_mm2; ///< their sum is the surface's area
};

/// One sample or more in every triangle, about `count` of equal area where triangles are large: triangle t gets
/// n = ceil(count * area(t) / area) samples of area(t) / n each, placed by the triangular van der Corput sequence
/// (K. Basu and A. Owen, "Low discrepancy constructions in the triangle", SIAM J. Numer. Anal. 53, 2015): the first is
/// the centroid, the first 4^k are the centroids of the regular subdivision into 4^k triangles. The weights follow
/// area alone, so that vertices, whose density differs from mesh to mesh, have no say. O(triangles + count).
SurfaceSamples sample_surface(const Mesh &mesh, std::int64_t count);

double surface_area_mm2(const Mesh &mesh);

} // namespace volsurf
