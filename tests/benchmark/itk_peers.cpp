#include "benchmark/peers.h"

#include <itkGradientMagnitudeRecursiveGaussianImageFilter.h>
#include <itkMorphologicalWatershedImageFilter.h>
#include <itkMultiThreaderBase.h>
#include <itkWatershedImageFilter.h>

#include <algorithm>
#include <unordered_set>

namespace volsurf::bench {

namespace {

using Image = itk::Image<float, 3>;

/// The volume's samples, not copied.
Image::Pointer wrapped(const Volume &volume)
{
  Image::SizeType size;
  for (unsigned axis = 0; axis < 3; ++axis)
    size[axis] = static_cast<itk::SizeValueType>(volume.grid.size[axis]);
  auto image = Image::New();
  image->SetRegions(size);
  image->SetSpacing(volume.grid.spacing_mm.data());
  image->GetPixelContainer()->SetImportPointer(const_cast<float *>(volume.samples.data()), volume.samples.size(),
                                               false);
  return image;
}

Image::Pointer gradient_of(const Volume &volume, const RunOptions &options)
{
  const auto threads = static_cast<itk::ThreadIdType>(options.threads);
  itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(threads);
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
  const auto filter = itk::GradientMagnitudeRecursiveGaussianImageFilter<Image, Image>::New();
  filter->SetInput(wrapped(volume));
  filter->SetSigma(options.sigma_mm.value_or(mean_spacing_mm(volume.grid)));
  filter->SetNumberOfWorkUnits(threads);
  filter->Update();
  return filter->GetOutput();
}

/// The number of labels in an image.
template <typename Labels> std::size_t count_labels(const Labels &labels)
{
  const auto *const first = labels.GetBufferPointer();
  std::unordered_set<typename Labels::PixelType> found{*first};
  for (std::size_t i = 1; i < labels.GetPixelContainer()->Size(); ++i)
    if (first[i] != first[i - 1])
      found.insert(first[i]);
  return found.size();
}

} // namespace

Outcome run_itk_morphological_watershed(const Volume &volume, const RunOptions &options, bool fully_connected)
{
  using Labels = itk::Image<std::uint32_t, 3>;
  StageTimer timer;
  const Image::Pointer gradient = gradient_of(volume, options);
  timer.lap("gradient");
  const auto watershed = itk::MorphologicalWatershedImageFilter<Image, Labels>::New();
  watershed->SetInput(gradient);
  watershed->SetLevel(static_cast<float>(options.delta));
  watershed->SetMarkWatershedLine(false);
  watershed->SetFullyConnected(fully_connected);
  watershed->SetNumberOfWorkUnits(static_cast<itk::ThreadIdType>(options.threads));
  watershed->Update();
  timer.lap("watershed");
  return {timer.seconds(), {{"regions", count_labels(*watershed->GetOutput())}}, {}};
}

Outcome run_itk_watershed(const Volume &volume, const RunOptions &options)
{
  StageTimer timer;
  const Image::Pointer gradient = gradient_of(volume, options);
  timer.lap("gradient");
  const float *const first = gradient->GetBufferPointer();
  const auto [low, high] = std::minmax_element(first, first + volume.samples.size());
  const auto watershed = itk::WatershedImageFilter<Image>::New();
  watershed->SetInput(gradient);
  watershed->SetThreshold(0);
  watershed->SetLevel(options.delta / (*high - *low)); // it wants a part of the largest depth
  watershed->Update();
  timer.lap("watershed");
  return {timer.seconds(), {{"regions", count_labels(*watershed->GetOutput())}}, {}};
}

} // namespace volsurf::bench
