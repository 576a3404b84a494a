#include "volsurf/pipeline/finishing.h"

#include "volsurf/field/noise_level.h"
#include "volsurf/field/oversample.h"
#include "volsurf/surface/fit.h"
#include "volsurf/surface/refine.h"

#include <algorithm>

namespace volsurf {

namespace {

/// Placement looks at the volume with a little less blur than the merge, for the sake of creases and thin walls: its
/// noise is evened out along the surface.
constexpr double kPlacementBlur = 0.8;

/// But where slices are thick, with as much more as they need to tell an edge between them.
constexpr double kMostPlacementBlur = 1.5;

/// Where slices are thick, edges of triangles that are longer than this many of the scan's pixels are halved.
constexpr double kLongestEdge = 2;

double placement_sigma_mm(const Grid &grid, double sigma_mm)
{
  const double slice_mm = (has_thick_slices(grid) ? grid.oversampling : 1) * largest_spacing_mm(grid);
  return std::min(kPlacementBlur * std::max(sigma_mm, slice_mm), kMostPlacementBlur * sigma_mm);
}

/// `noise` is the sd in a sample.
EdgeLocator make_locator(const Volume &volume, double sigma_mm, double noise)
{
  const double placement_mm = placement_sigma_mm(volume.grid, sigma_mm);
  FieldOptions field;
  field.sigma_mm = placement_mm;
  // On a finer grid noise moves neighbouring points alike, so that each knows less.
  const double gradient_noise = volume.grid.oversampling * (noise * EdgeField(volume, field).noise_gain());
  return {volume, placement_mm, gradient_noise};
}

/// The scan's passes; so many times as many reach as far on a finer grid.
SmoothingOptions smoothing_on(const Grid &grid, SmoothingOptions smoothing)
{
  if (!smoothing.iterations)
    smoothing.iterations = grid.oversampling * usual_iterations(smoothing.strength);
  return smoothing;
}

} // namespace

Finisher::Finisher(const Volume &volume, double sigma_mm, const Settings &settings)
    : grid_(volume.grid), settings_(settings), sigma_mm_(sigma_mm)
{
  if (!settings.snap || !(settings.smoothing.strength > 0) || settings.field.edge_map)
    return;
  volume_ = &volume;
  noise_ = measure_sample_noise(volume);
}

PlacementResult Finisher::place(Mesh &mesh)
{
  const double strength = settings_.smoothing.strength / SmoothingOptions{}.strength;
  if (encloses_one_thing(mesh))
    return fit_mesh(mesh, *volume_, scan_grid(grid_), noise_, kLeastFitError * strength);
  if (!locator_)
    locator_ = make_locator(*volume_, sigma_mm_, noise_);
  const auto find_edge = [this](const Vec3 &index, const Vec3 &direction, double limit_mm) {
    return locator_->find(index, direction, limit_mm);
  };
  return snap_mesh(mesh, grid_, find_edge, kLeastError * strength);
}

Finishing Finisher::finish(Mesh &mesh)
{
  Finishing finishing;
  finishing.smoothing = smooth_mesh(mesh, grid_, smoothing_on(grid_, settings_.smoothing));
  if (volume_ == nullptr)
    return finishing;
  if (has_thick_slices(grid_))
    halve_long_edges(mesh, kLongestEdge * grid_.oversampling * smallest_spacing_mm(grid_));
  finishing.snap = place(mesh);
  return finishing;
}

} // namespace volsurf
