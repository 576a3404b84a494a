#include "volsurf/core/grid.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

Vec3 multiply(const Mat3 &m, const Vec3 &v)
{
  Vec3 result{};
  for (int row = 0; row < 3; ++row)
    result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
  return result;
}

Mat3 inverse(const Mat3 &m)
{
  const double scale = 1.0 / determinant(m);
  Mat3 result{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const int r1 = (column + 1) % 3;
      const int r2 = (column + 2) % 3;
      const int c1 = (row + 1) % 3;
      const int c2 = (row + 2) % 3;
      result[row][column] = scale * (m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]);
    }
  return result;
}

} // namespace

Vec3 index_to_world(const Grid &grid, const Vec3 &index)
{
  const Vec3 scaled{grid.spacing_mm[0] * index[0], grid.spacing_mm[1] * index[1], grid.spacing_mm[2] * index[2]};
  const Vec3 turned = multiply(grid.direction, scaled);
  return {grid.origin_mm[0] + turned[0], grid.origin_mm[1] + turned[1], grid.origin_mm[2] + turned[2]};
}

Vec3 world_to_index(const Grid &grid, const Vec3 &world)
{
  const Vec3 offset{world[0] - grid.origin_mm[0], world[1] - grid.origin_mm[1], world[2] - grid.origin_mm[2]};
  const Vec3 scaled = multiply(inverse(grid.direction), offset);
  return {scaled[0] / grid.spacing_mm[0], scaled[1] / grid.spacing_mm[1], scaled[2] / grid.spacing_mm[2]};
}

double determinant(const Mat3 &m)
{
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

bool is_mirrored(const Grid &grid)
{
  return determinant(grid.direction) < 0;
}

double voxel_volume_mm3(const Grid &grid)
{
  return grid.spacing_mm[0] * grid.spacing_mm[1] * grid.spacing_mm[2];
}

double face_area_mm2(const Grid &grid, int axis)
{
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  Vec3 u{};
  Vec3 v{};
  for (int i = 0; i < 3; ++i) {
    u[i] = grid.direction[i][a] * grid.spacing_mm[a];
    v[i] = grid.direction[i][b] * grid.spacing_mm[b];
  }
  return std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

double smallest_spacing_mm(const Grid &grid)
{
  return *std::min_element(grid.spacing_mm.begin(), grid.spacing_mm.end());
}

double largest_spacing_mm(const Grid &grid)
{
  return *std::max_element(grid.spacing_mm.begin(), grid.spacing_mm.end());
}

bool has_thick_slices(const Grid &grid)
{
  return largest_spacing_mm(grid) > 1.5 * smallest_spacing_mm(grid);
}

double mean_spacing_mm(const Grid &grid)
{
  const double smallest = smallest_spacing_mm(grid);
  double product = 1;
  for (const double spacing : grid.spacing_mm)
    product *= spacing / smallest;
  return smallest * std::cbrt(product);
}

Grid cell_centre_grid(const Grid &grid)
{
  Grid cells = grid;
  cells.size = grid.cell_size();
  cells.origin_mm = index_to_world(grid, {0.5, 0.5, 0.5});
  return cells;
}

Grid voxel_corner_grid(const Grid &grid)
{
  Grid corners = grid;
  for (std::int64_t &size : corners.size)
    ++size;
  corners.origin_mm = index_to_world(grid, {-0.5, -0.5, -0.5});
  return corners;
}

} // namespace volsurf
