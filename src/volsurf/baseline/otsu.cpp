#include "volsurf/baseline/otsu.h"

#include "volsurf/interop/itk_image.h"

#include <itkImageToHistogramFilter.h>
#include <itkOtsuThresholdCalculator.h>

#include <algorithm>

namespace volsurf {

namespace {

constexpr unsigned int kBins = 256;

} // namespace

double otsu_value(const Volume &volume)
{
  const auto [lowest, highest] = std::minmax_element(volume.samples.begin(), volume.samples.end());
  if (*lowest == *highest)
    return *lowest;
  using ToHistogram = itk::Statistics::ImageToHistogramFilter<ItkVolume>;
  const auto to_histogram = ToHistogram::New();
  to_histogram->SetInput(borrow_volume(volume));
  ToHistogram::HistogramSizeType bins(1);
  bins.Fill(kBins);
  to_histogram->SetHistogramSize(bins);
  to_histogram->SetAutoMinimumMaximum(true);
  run_itk_filter(*to_histogram, "histogram", {});
  const auto calculator = itk::OtsuThresholdCalculator<ToHistogram::HistogramType, double>::New();
  calculator->SetInput(to_histogram->GetOutput());
  run_itk_filter(*calculator, "otsu", {});
  return calculator->GetThreshold();
}

} // namespace volsurf
