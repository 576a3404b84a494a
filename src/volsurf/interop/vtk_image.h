// Volume to vtkImageData.
#pragma once

#include "volsurf/core/volume.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace volsurf {

/// A view of the samples at their indices: spacing 1, origin 0. The volume must outlive it, and nobody may write to it.
vtkSmartPointer<vtkImageData> borrow_as_vtk_image(const Volume &volume);

} // namespace volsurf
