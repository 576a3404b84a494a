// Small meshes for the writers.
#pragma once

#include "volsurf/core/mesh.h"
#include "volsurf/core/provenance.h"

#include <random>

namespace volsurf::test {

inline Provenance provenance()
{
  return {"volsurf 1.2.3", "head.nrrd", "--delta 20 --keep 5%"};
}

/// Two triangles that share an edge, and two points in one place, which must not be merged.
inline Mesh small_mesh()
{
  Mesh mesh;
  mesh.points = {{0.1F, -0.2F, 0.3F}, {1234.567F, 0, 0}, {0, 1e-7F, 0}, {-1, -1, -1}, {-1, -1, -1}};
  mesh.triangles = {{0, 1, 2}, {2, 1, 4}};
  mesh.region_a = {7, 4000000000U};
  mesh.region_b = {1, 2};
  mesh.persistence = {0.1F, 30};
  mesh.component = {1, 2};
  mesh.cap = {0, 1};
  return mesh;
}

/// A mesh that compresses badly.
inline Mesh random_mesh(int triangles)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> coordinate(-100, 100);
  std::uniform_int_distribution<PointId> id(0, static_cast<PointId>(triangles) - 1);
  Mesh mesh;
  for (int i = 0; i < triangles; ++i) {
    mesh.points.push_back({coordinate(random), coordinate(random), coordinate(random)});
    mesh.triangles.push_back({id(random), id(random), id(random)});
    mesh.region_a.push_back(id(random));
    mesh.region_b.push_back(id(random));
    mesh.persistence.push_back(coordinate(random));
    mesh.component.push_back(1);
    mesh.cap.push_back(0);
  }
  return mesh;
}

} // namespace volsurf::test
