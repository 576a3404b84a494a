#include "volsurf/interop/zero_surface.h"

#include "volsurf/interop/vtk_mesh.h"

#include <utility>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace volsurf {

namespace {

/// A view of the samples, at their indices; they must outlive it.
vtkSmartPointer<vtkImageData> to_image(const Volume &volume)
{
  vtkNew<vtkFloatArray> samples;
  // VTK takes pointers to what it does not change without const.
  samples->SetArray(const_cast<float *>(volume.samples.data()), static_cast<vtkIdType>(volume.samples.size()), 1);
  auto image = vtkSmartPointer<vtkImageData>::New();
  const Index3 &size = volume.grid.size;
  image->SetDimensions(static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2]));
  image->GetPointData()->SetScalars(samples);
  return image;
}

} // namespace

Mesh zero_surface(const Volume &volume)
{
  const auto image = to_image(volume);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0);
  edges->ComputeNormalsOff();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  Mesh mesh = from_poly_data(*edges->GetOutput());
  for (Point &point : mesh.points) {
    const Vec3 world = index_to_world(volume.grid, {point[0], point[1], point[2]});
    point = {static_cast<float>(world[0]), static_cast<float>(world[1]), static_cast<float>(world[2])};
  }
  for (Triangle &triangle : mesh.triangles) // VTK's normals point to negative values
    std::swap(triangle[1], triangle[2]);
  return mesh;
}

} // namespace volsurf
