#include "volsurf/compare/nearest_surface.h"

#include "volsurf/compare/triangle_tree.h"
#include "volsurf/core/parallel.h"
#include "volsurf/core/vec3.h"

namespace volsurf {

namespace {

constexpr std::int64_t kPointsPerSlab = 4096;

} // namespace

struct NearestSurface::Parts {
  explicit Parts(const Mesh &of) : mesh(of), tree(mesh), normals(find_pseudonormals(mesh)) {}

  Mesh mesh;
  TriangleTree tree;
  Pseudonormals normals;
};

NearestSurface::NearestSurface(const Mesh &mesh) : parts_(std::make_unique<Parts>(mesh)) {}

NearestSurface::~NearestSurface() = default;

std::vector<double> NearestSurface::signed_distances(const std::vector<Vec3> &points) const
{
  std::vector<double> distances(points.size());
  parallel_for_slabs(static_cast<std::int64_t>(points.size()), kPointsPerSlab, [&](const Slab &slab) {
    NearestPlace place;
    for (auto i = static_cast<std::size_t>(slab.begin); i < static_cast<std::size_t>(slab.end); ++i) {
      place = parts_->tree.nearest(points[i], place.triangle); // neighbours in the list are neighbours in space
      const Point &normal = parts_->normals[place.triangle][static_cast<std::size_t>(place.feature)];
      distances[i] = std::copysign(std::sqrt(place.squared), dot(place.offset, to_vec3(normal)));
    }
  });
  return distances;
}

} // namespace volsurf
