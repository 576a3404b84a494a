#include "volsurf/pipeline/finishing.h"

#include "volsurf/field/noise_level.h"
#include "volsurf/surface/refine.h"

#include <algorithm>

namespace volsurf {

namespace {

/// Placement looks at the volume with a little less blur than the merge, for the sake of creases and thin walls: its
/// noise is evened out along the surface.
constexpr double kPlacementBlur = 0.8;

/// But where slices are thick, with as much more as they need to tell an edge between them.
constexpr double kMostPlacementBlur = 1.5;

/// Slices are thick where they are so many times as far apart as pixels; then edges of triangles that are longer than
/// this many pixels are halved.
constexpr double kThickSlices = 1.5;
constexpr double kLongestEdge = 2;

double largest_spacing_mm(const Grid &grid)
{
  return *std::max_element(grid.spacing_mm.begin(), grid.spacing_mm.end());
}

double placement_sigma_mm(const Grid &grid, double sigma_mm)
{
  return std::min(kPlacementBlur * std::max(sigma_mm, largest_spacing_mm(grid)), kMostPlacementBlur * sigma_mm);
}

EdgeLocator make_locator(const Volume &volume, double sigma_mm)
{
  const double placement_mm = placement_sigma_mm(volume.grid, sigma_mm);
  FieldOptions field;
  field.sigma_mm = placement_mm;
  return {volume, placement_mm, measure_noise(volume, EdgeField(volume, field)).gradient};
}

} // namespace

Finisher::Finisher(const Volume &volume, double sigma_mm, const Settings &settings)
    : grid_(volume.grid), settings_(settings)
{
  if (settings.snap && settings.smoothing.strength > 0 && !settings.field.edge_map)
    locator_ = make_locator(volume, sigma_mm);
}

Finishing Finisher::finish(Mesh &mesh) const
{
  Finishing finishing;
  finishing.smoothing = smooth_mesh(mesh, grid_, settings_.smoothing);
  if (!locator_)
    return finishing;
  const double pixel_mm = smallest_spacing_mm(grid_);
  if (largest_spacing_mm(grid_) > kThickSlices * pixel_mm)
    halve_long_edges(mesh, kLongestEdge * pixel_mm);
  const auto find_edge = [this](const Vec3 &index, const Vec3 &direction, double limit_mm) {
    return locator_->find(index, direction, limit_mm);
  };
  const double strength = settings_.smoothing.strength / SmoothingOptions{}.strength;
  finishing.snap = snap_mesh(mesh, grid_, find_edge, kLeastError * strength);
  return finishing;
}

} // namespace volsurf
