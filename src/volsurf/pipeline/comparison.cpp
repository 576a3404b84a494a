#include "volsurf/pipeline/comparison.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace volsurf {

namespace {

double default_tolerance_mm(const Shape &a, const Shape &b)
{
  if (a.mask && b.mask)
    return std::min(smallest_spacing_mm(a.mask->grid), smallest_spacing_mm(b.mask->grid));
  if (a.mask || b.mask)
    return smallest_spacing_mm((a.mask ? a.mask : b.mask)->grid);
  return 1;
}

Overlap overlap_of(const Shape &a, const Shape &b, double spacing_mm)
{
  if (a.mask && b.mask)
    if (const std::optional<Overlap> overlap = measure_lattice_overlap(*a.mask, *b.mask))
      return *overlap;
  if (a.mask.has_value() == b.mask.has_value())
    return measure_overlap(a.surface, b.surface, spacing_mm);
  if (a.mask)
    return measure_overlap(*a.mask, b.surface);
  Overlap overlap = measure_overlap(*b.mask, a.surface);
  std::swap(overlap.samples_a, overlap.samples_b);
  return overlap;
}

void warn_of_open_surface(const Shape &shape, const std::string &name, std::vector<std::string> &warnings)
{
  if (!shape.is_closed())
    warnings.push_back(name + " is not closed (" + std::to_string(shape.unbalanced_edges) +
                       " edges are open or turned): it has no inside, so that there is no overlap and no bias");
}

std::pair<double, double> extent(const Mesh &mesh, int axis)
{
  const auto [low, high] = std::minmax_element(mesh.points.begin(), mesh.points.end(),
                                               [=](const Point &p, const Point &q) { return p[axis] < q[axis]; });
  return {(*low)[axis], (*high)[axis]};
}

/// With `turn`, b is turned half round z, as between LPS and RAS.
bool boxes_meet(const Mesh &a, const Mesh &b, bool turn)
{
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low_a, high_a] = extent(a, axis);
    auto [low_b, high_b] = extent(b, axis);
    if (turn && axis < 2)
      std::tie(low_b, high_b) = std::make_pair(-high_b, -low_b);
    if (high_a < low_b || high_b < low_a)
      return false;
  }
  return true;
}

void warn_of_distant_bodies(const Mesh &a, const Mesh &b, std::vector<std::string> &warnings)
{
  if (boxes_meet(a, b, false))
    return;
  warnings.push_back(std::string("the boxes round A and B do not meet: are they in the same frame and unit?") +
                     (boxes_meet(a, b, true) ? " They would if one of them were in RAS (see --frame)" : ""));
}

} // namespace

Comparison compare(const Shape &a, const Shape &b, const ComparisonOptions &options, const Progress &progress)
{
  Comparison result;
  result.a_is_closed = a.is_closed();
  result.b_is_closed = b.is_closed();
  result.volume_a_mm3 = a.volume_mm3;
  result.volume_b_mm3 = b.volume_mm3;
  result.tolerance_mm = options.tolerance_mm.value_or(default_tolerance_mm(a, b));
  warn_of_open_surface(a, "A", result.warnings);
  warn_of_open_surface(b, "B", result.warnings);
  warn_of_distant_bodies(a.surface, b.surface, result.warnings);

  const DistanceOptions distance_options{result.tolerance_mm, options.samples};
  report_progress(progress, "distances from A to B", 0);
  DirectedDistances a_to_b = directed_distances(a.surface, *b.nearest, distance_options);
  report_progress(progress, "distances from B to A", 0);
  DirectedDistances b_to_a = directed_distances(b.surface, *a.nearest, distance_options);
  result.distances = combine(std::move(a_to_b), std::move(b_to_a));
  report_progress(progress, "vertices", 0);
  result.vertices = measure_vertex_distances(a.surface, b.surface);
  report_progress(progress, "overlap", 0);
  if (a.is_closed() && b.is_closed())
    result.overlap = overlap_of(a, b, options.spacing_mm);
  return result;
}

} // namespace volsurf
