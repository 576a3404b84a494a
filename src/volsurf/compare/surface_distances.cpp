#include "volsurf/compare/surface_distances.h"

#include "volsurf/compare/surface_samples.h"
#include "volsurf/core/vec3.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace volsurf {

namespace {

std::vector<Vec3> vertices(const Mesh &mesh)
{
  std::vector<Vec3> positions;
  positions.reserve(mesh.points.size());
  for (const Point &point : mesh.points)
    positions.push_back(to_vec3(point));
  return positions;
}

double largest(const std::vector<double> &signed_distances)
{
  double largest = 0;
  for (const double distance : signed_distances)
    largest = std::max(largest, std::abs(distance));
  return largest;
}

/// The smallest distance that this part of the area does not exceed.
double percentile(const std::vector<double> &distances, const std::vector<double> &areas, double part)
{
  std::vector<std::pair<double, double>> sorted(distances.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
    sorted[i] = {std::abs(distances[i]), areas[i]};
  std::sort(sorted.begin(), sorted.end());
  const double wanted = part * std::accumulate(areas.begin(), areas.end(), 0.0);
  double area = 0;
  for (const auto &[distance, piece] : sorted) {
    area += piece;
    if (area >= wanted)
      return distance;
  }
  return sorted.back().first;
}

} // namespace

DirectedDistances directed_distances(const Mesh &from, const NearestSurface &to, const DistanceOptions &options)
{
  const SurfaceSamples samples = sample_surface(from, options.samples);
  const std::vector<double> distances = to.signed_distances(samples.positions);
  DirectedDistances result;
  double sum = 0;
  double squares = 0;
  double signed_sum = 0;
  double within = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const double area = samples.areas_mm2[i];
    result.area_mm2 += area;
    sum += area * std::abs(distances[i]);
    squares += area * distances[i] * distances[i];
    signed_sum += area * distances[i];
    within += std::abs(distances[i]) <= options.tolerance_mm ? area : 0;
  }
  result.mean_mm = sum / result.area_mm2;
  result.rms_mm = std::sqrt(squares / result.area_mm2);
  result.signed_mean_mm = signed_sum / result.area_mm2;
  result.area_within = within / result.area_mm2;
  result.percentile95_mm = percentile(distances, samples.areas_mm2, 0.95);
  result.at_vertices_mm = to.signed_distances(vertices(from));
  result.maximum_mm = std::max(largest(distances), largest(result.at_vertices_mm));
  return result;
}

SurfaceDistances combine(DirectedDistances a_to_b, DirectedDistances b_to_a)
{
  const double area = a_to_b.area_mm2 + b_to_a.area_mm2;
  const auto over_both = [&](double a, double b) { return (a_to_b.area_mm2 * a + b_to_a.area_mm2 * b) / area; };
  SurfaceDistances both;
  both.assd_mm = over_both(a_to_b.mean_mm, b_to_a.mean_mm);
  both.rms_mm = std::sqrt(over_both(a_to_b.rms_mm * a_to_b.rms_mm, b_to_a.rms_mm * b_to_a.rms_mm));
  both.hd95_mm = std::max(a_to_b.percentile95_mm, b_to_a.percentile95_mm);
  both.hausdorff_mm = std::max(a_to_b.maximum_mm, b_to_a.maximum_mm);
  both.bias_mm = over_both(a_to_b.signed_mean_mm, -b_to_a.signed_mean_mm);
  both.surface_dice = over_both(a_to_b.area_within, b_to_a.area_within);
  both.a_to_b = std::move(a_to_b);
  both.b_to_a = std::move(b_to_a);
  return both;
}

SurfaceDistances measure_distances(const Mesh &a, const Mesh &b, const DistanceOptions &options)
{
  return combine(directed_distances(a, NearestSurface(b), options), directed_distances(b, NearestSurface(a), options));
}

} // namespace volsurf
