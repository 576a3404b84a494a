// Where a wall really is: the edge of the blurred volume along a line.
//
// A blur moves the maximum of |grad g| inwards where the wall is curved, by about sigma^2 times the mean curvature. The
// zero of Laplacian(g) + g_ww, w the direction of the gradient ("PLUS"), does not move to first order, since its two
// parts err in opposite directions. PLUS is positive on the side of lower g, so its sign tells which way to go.
//
// Source: van Vliet and Verbeek, "Edge localization by MoG filters: multiple-of-Gaussians" (1994); Bouma et al.,
// "Correction for the dislocation of curved surfaces caused by the PSF in 2D and 3D CT images", IEEE TPAMI 27 (2005).
#pragma once

#include "volsurf/core/located_edge.h"
#include "volsurf/field/smooth_volume.h"

#include <optional>

namespace volsurf {

class EdgeLocator {
public:
  /// Blurs by `sigma_mm`; `gradient_noise` is the sd of a component of the gradient under that blur, in intensity per
  /// mm. Takes 4 bytes per sample.
  EdgeLocator(const Volume &volume, double sigma_mm, double gradient_noise);

  /// From a fractional index along `direction` (of unit length, in mm along the grid's axes): the nearest edge on the
  /// way that PLUS points to; nothing where there is none within `limit_mm`. Thread-safe.
  std::optional<LocatedEdge> find(const Vec3 &index, const Vec3 &direction, double limit_mm) const;

private:
  SmoothVolume volume_;
  double error_times_gradient_;
};

} // namespace volsurf
