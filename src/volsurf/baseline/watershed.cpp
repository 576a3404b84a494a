#include "volsurf/baseline/watershed.h"

#include "volsurf/interop/itk_image.h"

#include <itkMorphologicalWatershedImageFilter.h>

namespace volsurf {

LabelVolume morphological_watershed(const Volume &edge_strength, double level, const Progress &progress)
{
  using Labels = itk::Image<std::uint32_t, 3>;
  const auto filter = itk::MorphologicalWatershedImageFilter<ItkVolume, Labels>::New();
  filter->SetInput(borrow_volume(edge_strength));
  filter->SetLevel(static_cast<float>(level));
  filter->SetMarkWatershedLine(false);
  filter->SetFullyConnected(true);
  run_itk_filter(*filter, "watershed", progress);
  const std::uint32_t *const labels = filter->GetOutput()->GetBufferPointer();
  return {edge_strength.grid, {labels, labels + edge_strength.samples.size()}};
}

} // namespace volsurf
