// The nearest point of a surface.
#pragma once

#include "volsurf/core/grid.h"
#include "volsurf/core/mesh.h"

#include <memory>
#include <vector>

namespace volsurf {

/// A surface prepared for questions: once per surface, however many others are compared with it.
class NearestSurface {
public:
  /// Every triangle must have an area (see drop_unused), and there must be one. Keeps a copy. O(n log n).
  explicit NearestSurface(const Mesh &mesh);
  ~NearestSurface();
  NearestSurface(const NearestSurface &) = delete;
  NearestSurface &operator=(const NearestSurface &) = delete;

  /// For each point, the distance to the nearest point of any triangle in mm, positive on the side to which the
  /// surface's normals point and negative on the other. The side has a meaning only where the surface is closed. On
  /// all threads; the same result for any number of them.
  std::vector<double> signed_distances(const std::vector<Vec3> &points) const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace volsurf
