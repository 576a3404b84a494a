// A box as a mesh, its faces anywhere.
#pragma once

#include "support/label_volumes.h"

namespace volsurf::support {

/// One cell as a mesh, its corners moved to those of a box.
inline Mesh box(const Vec3 &low, const Vec3 &high)
{
  const LabelledCells labels = label_cells({3, 3, 3}, 2, [](const Index3 &p) {
    return static_cast<BasinId>(p == Index3{1, 1, 1} ? 1 : 0);
  });
  Mesh mesh = mesh_of(labels, grid_of({3, 3, 3}), hull_sides(labels), true);
  for (Point &point : mesh.points)
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = static_cast<float>(point[axis] < 1.5F ? low[axis] : high[axis]);
  return mesh;
}

inline Grid cube(std::int64_t size)
{
  Grid grid;
  grid.size = {size, size, size};
  return grid;
}

} // namespace volsurf::support
