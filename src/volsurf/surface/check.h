// What a mesh is: measured on every result.
#pragma once

#include "volsurf/core/grid.h"
#include "volsurf/core/mesh.h"

#include <cstdint>

namespace volsurf {

struct MeshCheck {
  std::int64_t points = 0;
  std::int64_t triangles = 0;
  std::int64_t shells = 0;             ///< parts connected over points
  std::int64_t open_edges = 0;         ///< with one triangle
  std::int64_t non_manifold_edges = 0; ///< with three or more
  std::int64_t misoriented_edges = 0;  ///< with two triangles that run through it in the same direction
  std::int64_t euler_characteristic = 0;
  bool watertight = false; ///< not empty, and each edge has two triangles that run through it in opposite directions
  double genus = 0;        ///< sum over the shells of a watertight mesh, shells - euler_characteristic / 2; otherwise 0
  double area_mm2 = 0;
  double volume_mm3 = 0; ///< signed: positive where normals point outwards. Has a meaning for closed meshes only.
  Vec3 bounds_low_mm{0, 0, 0};
  Vec3 bounds_high_mm{0, 0, 0};
};

/// O(points + triangles).
MeshCheck check_mesh(const Mesh &mesh);

/// The check of two meshes beside each other, which share no point.
MeshCheck operator+(const MeshCheck &a, const MeshCheck &b);

/// The signed volume alone, in mm^3.
double signed_volume_mm3(const Mesh &mesh);

} // namespace volsurf
