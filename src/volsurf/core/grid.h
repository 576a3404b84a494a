// The sampling grid of a volume and its place in the world.
#pragma once

#include "volsurf/core/ids.h"

#include <array>

namespace volsurf {

using Index3 = std::array<std::int64_t, 3>;
using Vec3 = std::array<double, 3>;
using Mat3 = std::array<Vec3, 3>; ///< rows

/// Samples at integer positions 0 .. size-1 on each axis. World coordinates are LPS millimetres, as in ITK:
/// world = origin + direction * (spacing * index), where the columns of `direction` are the grid's axes.
struct Grid {
  Index3 size{0, 0, 0};
  Vec3 spacing_mm{1, 1, 1};
  Vec3 origin_mm{0, 0, 0};
  Mat3 direction{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  int oversampling = 1; ///< along each axis every so many-th sample is the scan's, those between are made of them

  std::int64_t sample_count() const { return size[0] * size[1] * size[2]; }
  Index3 cell_size() const { return {size[0] - 1, size[1] - 1, size[2] - 1}; }
  std::int64_t cell_count() const { return (size[0] - 1) * (size[1] - 1) * (size[2] - 1); }
};

/// Position of a (fractional) index in the world.
Vec3 index_to_world(const Grid &grid, const Vec3 &index);

/// Fractional index of a world position. The direction matrix must be invertible.
Vec3 world_to_index(const Grid &grid, const Vec3 &world);

double determinant(const Mat3 &matrix);

/// True where the grid's axes form a left-handed frame, so that windings must be swapped.
bool is_mirrored(const Grid &grid);

double voxel_volume_mm3(const Grid &grid);

/// The area of a face that is normal to an axis of the grid.
double face_area_mm2(const Grid &grid, int axis);

double smallest_spacing_mm(const Grid &grid);
double largest_spacing_mm(const Grid &grid);

/// Whether slices are more than 1.5 times as far apart as pixels are.
bool has_thick_slices(const Grid &grid);

/// The geometric mean, the side of a cube as large as a voxel; where all are equal exactly that.
double mean_spacing_mm(const Grid &grid);

/// The grid of the cells' centres: one sample less per axis, origin shifted by half a voxel.
Grid cell_centre_grid(const Grid &grid);

/// The grid of the corners of the voxels around the samples: one more per axis, origin half a voxel lower. Its cells
/// are the voxels, and its cell_centre_grid() is the grid itself.
Grid voxel_corner_grid(const Grid &grid);

} // namespace volsurf
