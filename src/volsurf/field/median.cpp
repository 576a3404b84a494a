#include "volsurf/field/median.h"

#include "volsurf/core/error.h"
#include "volsurf/interop/itk_image.h"

#include <itkMedianImageFilter.h>

namespace volsurf {

void filter_by_median(Volume &volume, int radius_voxels, const Progress &progress)
{
  if (radius_voxels < 0 || radius_voxels > kLargestMedian)
    throw UsageError("--median: found " + std::to_string(radius_voxels) + "; allowed are 0 to " +
                     std::to_string(kLargestMedian) + " voxels");
  if (radius_voxels == 0)
    return;
  using Filter = itk::MedianImageFilter<ItkVolume, ItkVolume>;
  const auto filter = Filter::New();
  filter->SetInput(borrow_volume(volume));
  filter->SetRadius(static_cast<Filter::RadiusValueType>(radius_voxels));
  run_itk_filter(*filter, "median", progress);
  std::copy_n(filter->GetOutput()->GetBufferPointer(), volume.samples.size(), volume.samples.begin());
}

} // namespace volsurf
