// ITK's recursive filter, an approximation of the same derivative of Gaussian, as an outside witness.
#include "volsurf/field/gradient.h"

#include "support/fields.h"

#include "volsurf/phantom/phantom.h"

#include <gtest/gtest.h>
#include <itkGradientMagnitudeRecursiveGaussianImageFilter.h>
#include <itkImage.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

std::vector<float> itk_gradient_magnitude(const Volume &volume, double sigma_mm)
{
  using Image = itk::Image<float, 3>;
  const auto image = Image::New();
  Image::SizeType size;
  Image::SpacingType spacing;
  for (unsigned axis = 0; axis < 3; ++axis) {
    size[axis] = static_cast<itk::SizeValueType>(volume.grid.size[axis]);
    spacing[axis] = volume.grid.spacing_mm[axis];
  }
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->Allocate();
  std::copy(volume.samples.begin(), volume.samples.end(), image->GetBufferPointer());
  const auto filter = itk::GradientMagnitudeRecursiveGaussianImageFilter<Image, Image>::New();
  filter->SetInput(image);
  filter->SetSigma(sigma_mm);
  filter->Update();
  const float *const values = filter->GetOutput()->GetBufferPointer();
  return {values, values + volume.samples.size()};
}

struct Difference {
  double largest = 0; ///< over the largest gradient
  double mean = 0;
};

/// Over the samples that are four sigma away from the border, which the two continue differently.
Difference difference_to_itk(const Volume &volume, double sigma_mm)
{
  const Volume ours = gradient_magnitude(EdgeField(volume, {sigma_mm, false}), volume.grid);
  const auto itks = itk_gradient_magnitude(volume, sigma_mm);
  Difference result;
  double largest = 0;
  std::int64_t count = 0;
  for_each_sample(volume.grid.size, [&](const Index3 &p, SampleId sample) {
    for (int axis = 0; axis < 3; ++axis) {
      const double depth = static_cast<double>(std::min(p[axis], volume.grid.size[axis] - 1 - p[axis]));
      if (depth * volume.grid.spacing_mm[axis] < 4 * sigma_mm)
        return;
    }
    const double difference = std::abs(static_cast<double>(ours.samples[sample]) - static_cast<double>(itks[sample]));
    largest = std::max(largest, static_cast<double>(itks[sample]));
    result.largest = std::max(result.largest, difference);
    result.mean += difference;
    ++count;
  });
  return {result.largest / largest, result.mean / static_cast<double>(count) / largest};
}

Volume head(const Index3 &size, const Vec3 &spacing)
{
  PhantomOptions options;
  options.size = size;
  options.spacing_mm = spacing;
  options.with_truth = false;
  return make_head_phantom(options).volume;
}

} // namespace

TEST(EdgeField, AgreesWithItksRecursiveGaussianOnAHead)
{
  const Volume volume = head({64, 64, 64}, {3, 3, 3});
  for (const double sigma_voxels : {1.0, 1.5, 2.0, 3.0}) {
    const Difference difference = difference_to_itk(volume, 3 * sigma_voxels);
    EXPECT_LT(difference.largest, 0.02) << sigma_voxels;
    EXPECT_LT(difference.mean, 0.003) << sigma_voxels;
  }
}

TEST(EdgeField, AgreesWithItksRecursiveGaussianOnAnisotropicVoxels)
{
  const Difference difference = difference_to_itk(head({72, 64, 44}, {2.5, 3, 4}), 5);
  EXPECT_LT(difference.largest, 0.02);
  EXPECT_LT(difference.mean, 0.003);
}
