#include "volsurf/interop/itk_image.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"

#include <itkProcessObject.h>

namespace volsurf {

ItkVolume::Pointer borrow_volume(const Volume &volume)
{
  ItkVolume::SizeType size;
  for (unsigned int axis = 0; axis < 3; ++axis)
    size[axis] = static_cast<itk::SizeValueType>(volume.grid.size[axis]);
  auto image = ItkVolume::New();
  image->SetRegions(size);
  image->SetSpacing(volume.grid.spacing_mm.data());
  image->GetPixelContainer()->SetImportPointer(const_cast<float *>(volume.samples.data()), volume.samples.size(),
                                               false);
  return image;
}

void run_itk_filter(itk::ProcessObject &filter, std::string_view stage, const Progress &progress)
{
  filter.AddObserver(itk::ProgressEvent(), [&](const itk::EventObject & /*event*/) {
    if (progress && !progress(stage, filter.GetProgress()))
      filter.AbortGenerateDataOn();
  });
  filter.SetNumberOfWorkUnits(static_cast<itk::ThreadIdType>(active_threads()));
  report_progress(progress, stage, 0);
  try {
    filter.Update();
  } catch (const itk::ProcessAborted &) {
    throw Cancelled();
  } catch (const itk::ExceptionObject &error) {
    throw Error(std::string(stage) + ": " + error.GetDescription());
  }
}

} // namespace volsurf
