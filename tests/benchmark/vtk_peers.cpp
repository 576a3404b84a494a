#include "benchmark/peers.h"

#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkImageGradientMagnitude.h>
#include <vtkMultiThreader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkSMPTools.h>

namespace volsurf::bench {

namespace {

/// The volume's samples, not copied.
void wrap(const Volume &volume, vtkImageData &image)
{
  vtkNew<vtkFloatArray> samples;
  constexpr int kKeepOwnership = 1;
  samples->SetArray(const_cast<float *>(volume.samples.data()), volume.grid.sample_count(), kKeepOwnership);
  image.SetDimensions(static_cast<int>(volume.grid.size[0]), static_cast<int>(volume.grid.size[1]),
                      static_cast<int>(volume.grid.size[2]));
  image.SetSpacing(volume.grid.spacing_mm.data());
  image.GetPointData()->SetScalars(samples);
}

/// Debian's VTK runs vtkSMPTools on one thread unless told otherwise.
void use_threads(int threads)
{
  vtkSMPTools::SetBackend(threads > 1 ? "TBB" : "Sequential");
  vtkSMPTools::Initialize(threads);
  vtkMultiThreader::SetGlobalMaximumNumberOfThreads(threads);
}

} // namespace

Outcome run_vtk_surface(const Volume &volume, const RunOptions &options, const VtkOptions &vtk)
{
  use_threads(options.threads);
  vtkNew<vtkImageData> image;
  wrap(volume, *image);

  StageTimer timer;
  vtkNew<vtkImageGradientMagnitude> gradient;
  gradient->SetInputData(image);
  gradient->SetDimensionality(3);
  gradient->Update();
  timer.lap("gradient");

  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, options.iso);
  contour->SetComputeNormals(vtk.arrays);
  contour->SetComputeScalars(vtk.arrays);
  contour->Update();
  timer.lap("iso-surface");

  Outcome outcome;
  outcome.facts = {{"triangles", contour->GetOutput()->GetNumberOfPolys()}, {"smp", vtkSMPTools::GetBackend()}};
  if (vtk.largest_region) {
    vtkNew<vtkPolyDataConnectivityFilter> connectivity;
    connectivity->SetInputConnection(contour->GetOutputPort());
    connectivity->SetExtractionModeToLargestRegion();
    connectivity->Update();
    timer.lap("largest region");
    outcome.facts["components"] = connectivity->GetNumberOfExtractedRegions();
  }
  outcome.seconds = timer.seconds();
  return outcome;
}

} // namespace volsurf::bench
