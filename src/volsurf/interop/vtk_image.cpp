#include "volsurf/interop/vtk_image.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace volsurf {

vtkSmartPointer<vtkImageData> borrow_as_vtk_image(const Volume &volume)
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

} // namespace volsurf
