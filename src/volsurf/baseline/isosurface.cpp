#include "volsurf/baseline/isosurface.h"

#include "volsurf/interop/vtk_image.h"
#include "volsurf/interop/vtk_mesh.h"

#include <vtkFlyingEdges3D.h>
#include <vtkMarchingCubes.h>

namespace volsurf {

namespace {

/// The two filters have the same settings, but no common base that has them.
template <typename Filter> Mesh surface_by(vtkImageData &image, const Grid &grid, double iso)
{
  const auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(&image);
  filter->SetValue(0, iso);
  filter->ComputeNormalsOff();
  filter->ComputeGradientsOff();
  filter->ComputeScalarsOff();
  filter->Update();
  return from_index_space(*filter->GetOutput(), grid);
}

} // namespace

Mesh isosurface(const Volume &volume, double iso, IsosurfaceFilter filter)
{
  const auto image = borrow_as_vtk_image(volume);
  return filter == IsosurfaceFilter::flying_edges ? surface_by<vtkFlyingEdges3D>(*image, volume.grid, iso)
                                                  : surface_by<vtkMarchingCubes>(*image, volume.grid, iso);
}

} // namespace volsurf
