// Distances between the vertices of two meshes, as of two clouds of points.
#pragma once

#include "volsurf/core/mesh.h"

namespace volsurf {

/// The measures of the paper. They know nothing of area, and depend on how densely each mesh is tessellated.
/// docs/metrics.md has the formulas, and what is assumed of the paper's.
struct VertexDistances {
  double mse_mm2 = 0;
  double snr_db = 0; ///< +infinity where mse_mm2 is 0
  double mae_mm = 0;
  double hausdorff_mm = 0;
};

/// b is the reference, whose extent is the signal of the ratio; all else is symmetric. Neither may be without points.
/// O((a + b) log b), on all threads; the same result for any number of them.
VertexDistances measure_vertex_distances(const Mesh &a, const Mesh &b);

} // namespace volsurf
