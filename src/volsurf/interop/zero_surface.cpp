#include "volsurf/interop/zero_surface.h"

#include "volsurf/interop/vtk_image.h"
#include "volsurf/interop/vtk_mesh.h"

#include <utility>
#include <vtkFlyingEdges3D.h>
#include <vtkNew.h>

namespace volsurf {

Mesh zero_surface(const Volume &volume)
{
  const auto image = borrow_as_vtk_image(volume);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0);
  edges->ComputeNormalsOff();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  Mesh mesh = from_index_space(*edges->GetOutput(), volume.grid);
  for (Triangle &triangle : mesh.triangles) // VTK's normals point to negative values
    std::swap(triangle[1], triangle[2]);
  return mesh;
}

} // namespace volsurf
