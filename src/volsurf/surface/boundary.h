// The boundary E(delta): the faces between cells that the surface separates.
//
// Source: the paper, algorithm 3, and docs/method.md. What lies outside the volume counts as part of the background.
#pragma once

#include "volsurf/core/cell_labels.h"
#include "volsurf/surface/face_set.h"

#include <vector>

namespace volsurf {

/// What the surface separates: cells on different sides. Side 0 is what the user did not ask for; it is never inside.
struct Sides {
  std::vector<RegionId> of_basin;
  RegionId outside = 0; ///< of what lies outside the volume
};

/// The faces whose two cells lie on different sides, those at the border of the volume included. Parallel, O(cells).
FaceSet find_boundary(const CellLabels &cells, const Sides &sides);

} // namespace volsurf
