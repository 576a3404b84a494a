// What a user would use instead of volsurf, or compare it with. Each reads nothing and writes nothing: from the volume
// in memory to its result in memory.
#pragma once

#include "benchmark/measured_run.h"

namespace volsurf::bench {

/// vtkImageGradientMagnitude, and vtkFlyingEdges3D of the scan at an iso value.
struct VtkOptions {
  bool arrays = true;          ///< normals and scalars at the points, VTK's default
  bool largest_region = false; ///< vtkPolyDataConnectivityFilter on top
};
Outcome run_vtk_surface(const Volume &volume, const RunOptions &options, const VtkOptions &vtk);

/// itk::GradientMagnitudeRecursiveGaussianImageFilter, then itk::MorphologicalWatershedImageFilter with level = delta,
/// every sample labelled. `fully_connected` takes samples that meet at a corner for neighbours, as volsurf does; ITK's
/// default does not.
Outcome run_itk_morphological_watershed(const Volume &volume, const RunOptions &options, bool fully_connected);

/// The same gradient, then itk::WatershedImageFilter with level = delta.
Outcome run_itk_watershed(const Volume &volume, const RunOptions &options);

/// volsurf's gradient, then the region merge as it is written down (plain_kruskal.h). One thread.
Outcome run_plain_kruskal(const Volume &volume, const RunOptions &options);

/// volsurf's gradient, then the persistence of GUDHI's cubical complex. One thread.
Outcome run_gudhi(const Volume &volume, const RunOptions &options);

} // namespace volsurf::bench
