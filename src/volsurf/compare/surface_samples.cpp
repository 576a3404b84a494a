#include "volsurf/compare/surface_samples.h"

#include "volsurf/core/vec3.h"

namespace volsurf {

namespace {

double triangle_area(const Mesh &mesh, std::size_t t)
{
  return 0.5 * length(doubled_area_normal(mesh, t));
}

/// The index-th point: each digit of the index in base 4, the lowest first, chooses one of the four triangles that the
/// middles of the sides cut the present one into: 0 is the inner one, 1 to 3 those at the corners.
Vec3 van_der_corput(const std::array<Vec3, 3> &arms, const Vec3 &centroid, std::int64_t index)
{
  Vec3 place = centroid;
  double scale = 1; // of the present triangle; negative where it is turned round
  for (; index > 0; index /= 4) {
    const auto digit = index % 4;
    if (digit > 0)
      place = plus(place, 0.5 * scale, arms[static_cast<std::size_t>(digit) - 1]);
    scale *= digit > 0 ? 0.5 : -0.5;
  }
  return place;
}

} // namespace

double surface_area_mm2(const Mesh &mesh)
{
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    area += triangle_area(mesh, t);
  return area;
}

SurfaceSamples sample_surface(const Mesh &mesh, std::int64_t count)
{
  const double whole_area = surface_area_mm2(mesh);
  SurfaceSamples samples;
  samples.positions.reserve(mesh.triangles.size() + static_cast<std::size_t>(count));
  samples.areas_mm2.reserve(mesh.triangles.size() + static_cast<std::size_t>(count));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double area = triangle_area(mesh, t);
    if (area <= 0)
      continue;
    const Vec3 a = corner(mesh, t, 0);
    const Vec3 centroid = plus(plus(a, 1.0 / 3, minus(corner(mesh, t, 1), a)), 1.0 / 3, minus(corner(mesh, t, 2), a));
    std::array<Vec3, 3> arms{};
    for (int i = 0; i < 3; ++i)
      arms[i] = minus(corner(mesh, t, i), centroid);
    const auto n = static_cast<std::int64_t>(std::ceil(static_cast<double>(count) * area / whole_area));
    for (std::int64_t i = 0; i < n; ++i) {
      samples.positions.push_back(van_der_corput(arms, centroid, i));
      samples.areas_mm2.push_back(area / static_cast<double>(n));
    }
  }
  return samples;
}

} // namespace volsurf
