#include "volsurf/baseline/isosurface.h"

#include "volsurf/interop/vtk_image.h"
#include "volsurf/interop/vtk_mesh.h"

#include <utility>
#include <vtkFlyingEdges3D.h>
#include <vtkMarchingCubes.h>

namespace volsurf {

namespace {

/// The two filters have the same settings, but no common base that has them.
template <typename Filter> Mesh surface_by(vtkImageData &image, double iso)
{
  const auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(&image);
  filter->SetValue(0, iso);
  filter->ComputeNormalsOff();
  filter->ComputeGradientsOff();
  filter->ComputeScalarsOff();
  filter->Update();
  return from_poly_data(*filter->GetOutput());
}

} // namespace

Mesh isosurface(const Volume &volume, double iso, IsosurfaceFilter filter)
{
  const auto image = borrow_as_vtk_image(volume);
  Mesh mesh = filter == IsosurfaceFilter::flying_edges ? surface_by<vtkFlyingEdges3D>(*image, iso)
                                                       : surface_by<vtkMarchingCubes>(*image, iso);
  for (Point &point : mesh.points) {
    const Vec3 world = index_to_world(volume.grid, {point[0], point[1], point[2]});
    point = {static_cast<float>(world[0]), static_cast<float>(world[1]), static_cast<float>(world[2])};
  }
  if (is_mirrored(volume.grid))
    for (Triangle &triangle : mesh.triangles)
      std::swap(triangle[1], triangle[2]);
  return mesh;
}

} // namespace volsurf
