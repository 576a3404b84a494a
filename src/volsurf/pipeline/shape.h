// A body, given by its surface or by labels, prepared to be compared with others.
#pragma once

#include "volsurf/compare/mask.h"
#include "volsurf/compare/nearest_surface.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace volsurf {

struct Shape {
  Mesh surface;                            ///< every triangle has an area; normals outwards where it is closed
  std::optional<Mask> mask;                ///< of a label volume
  std::unique_ptr<NearestSurface> nearest; ///< of `surface`; built once, however many others ask it
  std::int64_t unbalanced_edges = 0;
  double area_mm2 = 0;
  std::optional<double> volume_mm3; ///< of a closed surface what it encloses; of labels that of their voxels

  bool is_closed() const { return unbalanced_edges == 0; }
};

/// Points without a triangle and triangles without an area are dropped, and where points with the same coordinates
/// keep the surface from being closed, they become one. A closed surface with normals inwards is turned. Throws
/// InputError where nothing is left.
Shape shape_of_surface(Mesh mesh);

/// The samples that have one of these values; where none is given, that are above 0. Throws InputError where no sample
/// has one of them.
Shape shape_of_labels(const Volume &volume, const std::vector<float> &labels);

} // namespace volsurf
