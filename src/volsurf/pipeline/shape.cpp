#include "volsurf/pipeline/shape.h"

#include "volsurf/compare/surface_samples.h"
#include "volsurf/compare/tidy_mesh.h"
#include "volsurf/core/error.h"
#include "volsurf/surface/check.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace volsurf {

namespace {

void turn_outwards(Mesh &mesh)
{
  if (signed_volume_mm3(mesh) >= 0)
    return;
  for (Triangle &triangle : mesh.triangles)
    std::swap(triangle[1], triangle[2]);
}

std::string labels_text(const std::vector<float> &labels)
{
  if (labels.empty())
    return "no sample above 0";
  std::ostringstream text;
  text << "no sample with label ";
  for (std::size_t i = 0; i < labels.size(); ++i)
    text << (i > 0 ? " or " : "") << labels[i];
  return text.str();
}

} // namespace

Shape shape_of_surface(Mesh mesh)
{
  Shape shape;
  drop_unused(mesh);
  if (mesh.triangles.empty())
    throw InputError("found no triangle with an area; allowed: a surface");
  shape.unbalanced_edges = count_unbalanced_edges(mesh);
  if (shape.unbalanced_edges > 0) {
    Mesh welded = mesh;
    weld_points(welded);
    const std::int64_t left = count_unbalanced_edges(welded);
    if (left == 0) {
      mesh = std::move(welded);
      shape.unbalanced_edges = 0;
    }
  }
  if (shape.is_closed()) {
    turn_outwards(mesh);
    shape.volume_mm3 = signed_volume_mm3(mesh);
  }
  shape.area_mm2 = surface_area_mm2(mesh);
  shape.nearest = std::make_unique<NearestSurface>(mesh);
  shape.surface = std::move(mesh);
  return shape;
}

Shape shape_of_labels(const Volume &volume, const std::vector<float> &labels)
{
  Mask mask = mask_of_labels(volume, labels);
  if (mask.inside.empty()) {
    const auto [low, high] = std::minmax_element(volume.samples.begin(), volume.samples.end());
    std::ostringstream message;
    message << "found " << labels_text(labels) << "; allowed: labels that the volume has, " << *low << " to " << *high;
    throw InputError(message.str());
  }
  Shape shape = shape_of_surface(mask_surface(mask));
  shape.volume_mm3 = static_cast<double>(count_inside(mask)) * voxel_volume_mm3(mask.grid);
  shape.mask = std::move(mask);
  return shape;
}

} // namespace volsurf
