// Which samples of a grid belong to something.
#pragma once

#include "volsurf/core/mesh.h"
#include "volsurf/core/volume.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace volsurf {

struct Mask {
  Grid grid;
  std::vector<std::uint8_t> inside; ///< 0 or 1 per sample, x fastest
};

/// Part of a grid, or of its continuation, by the index of its first sample.
struct GridBox {
  Index3 low;
  Index3 size;
};

/// The samples of a label volume that have one of these values (where none is given: that are above 0), on the part of
/// its grid that holds them and one sample more on each side, also beyond the volume. Without such samples the mask has
/// no sample at all.
Mask mask_of_labels(const Volume &volume, const std::vector<float> &labels);

std::int64_t count_inside(const Mask &mask);

/// The same mask on another part of its grid: what is cut off is lost, what is added is outside.
Mask on_box(const Mask &mask, const GridBox &box);

/// Where b's first sample lies on a's grid, if their samples fall on each other (to 0.001 of a voxel).
std::optional<Index3> common_lattice(const Grid &a, const Grid &b);

/// The surface half-way between the samples inside and those outside (vtkFlyingEdges3D at half the mask), in world
/// coordinates, normals outwards. It is closed where no sample of the grid's own border is inside.
Mesh mask_surface(const Mask &mask);

} // namespace volsurf
