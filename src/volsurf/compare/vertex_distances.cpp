#include "volsurf/compare/vertex_distances.h"

#include "volsurf/core/parallel.h"
#include "volsurf/core/vec3.h"
#include "volsurf/interop/vtk_mesh.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <vtkNew.h>
#include <vtkStaticPointLocator.h>

namespace volsurf {

namespace {

constexpr std::int64_t kPointsPerSlab = 4096;

/// From each point of `from` to the nearest one of `to`, squared.
std::vector<double> squared_distances(const Mesh &from, const Mesh &to)
{
  const vtkSmartPointer<vtkPolyData> data = to_poly_data(to);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(data);
  locator->BuildLocator();
  std::vector<double> squares(from.points.size());
  parallel_for_slabs(static_cast<std::int64_t>(squares.size()), kPointsPerSlab, [&](const Slab &slab) {
    for (auto i = static_cast<std::size_t>(slab.begin); i < static_cast<std::size_t>(slab.end); ++i) {
      const Vec3 point = to_vec3(from.points[i]);
      const auto nearest = static_cast<std::size_t>(locator->FindClosestPoint(point.data()));
      const Vec3 offset = minus(point, to_vec3(to.points[nearest]));
      squares[i] = dot(offset, offset);
    }
  });
  return squares;
}

struct Sums {
  double mean_square = 0;
  double mean = 0;
  double maximum = 0;
};

Sums summarise(const std::vector<double> &squares)
{
  Sums sums;
  for (const double square : squares) {
    sums.mean_square += square;
    sums.mean += std::sqrt(square);
    sums.maximum = std::max(sums.maximum, std::sqrt(square));
  }
  sums.mean_square /= static_cast<double>(squares.size());
  sums.mean /= static_cast<double>(squares.size());
  return sums;
}

/// Mean squared distance of the points from their centroid.
double variance(const Mesh &mesh)
{
  const auto count = static_cast<double>(mesh.points.size());
  Vec3 centroid{0, 0, 0};
  for (const Point &point : mesh.points)
    centroid = plus(centroid, 1 / count, to_vec3(point));
  double sum = 0;
  for (const Point &point : mesh.points) {
    const Vec3 offset = minus(to_vec3(point), centroid);
    sum += dot(offset, offset);
  }
  return sum / count;
}

} // namespace

VertexDistances measure_vertex_distances(const Mesh &a, const Mesh &b)
{
  assert(!a.points.empty() && !b.points.empty());
  const Sums to_b = summarise(squared_distances(a, b));
  const Sums to_a = summarise(squared_distances(b, a));
  VertexDistances result;
  result.mse_mm2 = 0.5 * (to_b.mean_square + to_a.mean_square);
  result.mae_mm = 0.5 * (to_b.mean + to_a.mean);
  result.hausdorff_mm = std::max(to_b.maximum, to_a.maximum);
  result.snr_db =
      result.mse_mm2 > 0 ? 10 * std::log10(variance(b) / result.mse_mm2) : std::numeric_limits<double>::infinity();
  return result;
}

} // namespace volsurf
