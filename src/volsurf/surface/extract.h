// From faces to a triangle mesh.
//
// In: the kept faces, the cells' regions. Out: two triangles per face, with the arrays of Mesh, oriented from inside to
// outside, in world coordinates. Guarantees: points are shared and exactly allocated, triangles follow the order of
// faces, and no thread count changes a byte. Passes: number the points, place them, fill the triangles.
#pragma once

#include "volsurf/core/cell_labels.h"
#include "volsurf/core/mesh.h"
#include "volsurf/surface/boundary.h"
#include "volsurf/surface/components.h"

#include <functional>

namespace volsurf {

/// What the triangles' arrays tell of the regions.
struct RegionsOfCells {
  const CellLabels &cells;
  const std::vector<RegionId> &of_basin;
  RegionId background;                             ///< counts as the largest region: it is always outside
  BasinId background_basin;                        ///< a cap gets the saliency between it and the cap's basin
  std::function<float(BasinId, BasinId)> saliency; ///< called from several threads
};

/// The mesh of the kept faces. A face's inside is the cell on a side other than 0 (Sides); between two such sides the
/// smaller region. Its diagonal runs from its lowest corner to the opposite one.
///
/// With `manifold`, for a surface between one side and side 0, edges and points where the side touches itself are
/// split, so that each edge has two triangles; otherwise edges may have three or four faces.
Mesh extract_mesh(const KeptFaces &kept, const Grid &grid, const Sides &sides, const RegionsOfCells &regions,
                  bool manifold);

} // namespace volsurf
