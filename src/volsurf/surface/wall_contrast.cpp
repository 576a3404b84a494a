#include "volsurf/surface/wall_contrast.h"

#include "volsurf/core/parallel.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

constexpr std::int64_t kBlock = 3; ///< samples along each axis of a block

/// Sd in voxels of the Gaussian that weighs the samples around a place. 2 leaves the study's folded shapes up to 5 %
/// further off, 5 up to 7 %.
constexpr double kAround = 3;

/// Places of the sums: of weights, of parts inside (h), of parts beyond the layer (b), of intensities (g), of products.
enum SumOf { kW, kH, kB, kG, kHH, kHB, kBB, kHG, kBG, kGG };

} // namespace

WallContrasts::Sums WallContrasts::sums_of_block(const ScanModel &model, const Index3 &block)
{
  Index3 first;
  Index3 end;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = std::max(kBlock * block[axis], model.window.first_that_counts(axis));
    end[axis] = std::min(kBlock * (block[axis] + 1), model.window.end_of_those_that_count(axis));
  }
  Sums sums{};
  for (std::int64_t z = first[2]; z < end[2]; ++z)
    for (std::int64_t y = first[1]; y < end[1]; ++y)
      for (std::int64_t x = first[0]; x < end[0]; ++x) {
        const auto h = static_cast<double>(model.shares.row(y, z)[x]);
        const auto b = static_cast<double>(model.beyond_shares.row(y, z)[x]);
        const auto g = static_cast<double>(model.samples.row(y, z)[x]);
        const Sums products{1, h, b, g, h * h, h * b, b * b, h * g, b * g, g * g};
        for (std::size_t i = 0; i < sums.size(); ++i)
          sums[i] += products[i];
      }
  return sums;
}

WallContrasts::WallContrasts(const ScanModel &model)
{
  for (int axis = 0; axis < 3; ++axis)
    size_[axis] = (model.window.grid.size[axis] + kBlock - 1) / kBlock;
  blocks_.resize(static_cast<std::size_t>(size_[0] * size_[1] * size_[2]));
  parallel_for_slabs(size_[2], 1, [&](const Slab &slab) {
    for (std::int64_t z = slab.begin; z < slab.end; ++z)
      for (std::int64_t y = 0; y < size_[1]; ++y)
        for (std::int64_t x = 0; x < size_[0]; ++x)
          blocks_[index_of({x, y, z})] = sums_of_block(model, {x, y, z});
  });
  for (int axis = 0; axis < 3; ++axis)
    blur_along(axis);
}

void WallContrasts::blur_along(int axis)
{
  constexpr double kSigma = kAround / static_cast<double>(kBlock);
  const auto radius = static_cast<std::int64_t>(std::ceil(3 * kSigma));
  std::vector<double> weights;
  for (std::int64_t i = 0; i <= radius; ++i)
    weights.push_back(std::exp(-static_cast<double>(i * i) / (2 * kSigma * kSigma)));
  const Index3 strides{1, size_[0], size_[0] * size_[1]};
  const int across = axis == 2 ? 1 : 2; // lines along the axis, in slabs across another one
  const int other = 3 - axis - across;
  const std::int64_t length = size_[axis];
  parallel_for_slabs(size_[across], 1, [&](const Slab &slab) {
    std::vector<Sums> line(static_cast<std::size_t>(length));
    for (std::int64_t b = slab.begin; b < slab.end; ++b)
      for (std::int64_t a = 0; a < size_[other]; ++a) {
        Sums *const first = blocks_.data() + a * strides[other] + b * strides[across];
        for (std::int64_t i = 0; i < length; ++i)
          line[static_cast<std::size_t>(i)] = first[i * strides[axis]];
        for (std::int64_t i = 0; i < length; ++i) {
          Sums sums{};
          for (std::int64_t j = std::max<std::int64_t>(i - radius, 0); j <= std::min(i + radius, length - 1); ++j)
            for (std::size_t k = 0; k < sums.size(); ++k)
              sums[k] += weights[static_cast<std::size_t>(std::abs(i - j))] * line[static_cast<std::size_t>(j)][k];
          first[i * strides[axis]] = sums;
        }
      }
  });
}

WallContrasts::Sums WallContrasts::sums_around(const Vec3 &place) const
{
  Index3 low;
  Vec3 part;
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = static_cast<double>(kBlock - 1) / 2; // of a block
    const double block =
        std::clamp((place[axis] - middle) / static_cast<double>(kBlock), 0.0, static_cast<double>(size_[axis] - 1));
    low[axis] = std::min(static_cast<std::int64_t>(block), std::max<std::int64_t>(size_[axis] - 2, 0));
    part[axis] = block - static_cast<double>(low[axis]);
  }
  Sums sums{};
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    Index3 block = low;
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_high = (corner >> axis & 1) != 0;
      weight *= is_high ? part[axis] : 1 - part[axis];
      block[axis] = std::min(block[axis] + (is_high ? 1 : 0), size_[axis] - 1);
    }
    const Sums &of_block = blocks_[index_of(block)];
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i] += weight * of_block[i];
  }
  return sums;
}

std::optional<Contrast> WallContrasts::at(const Vec3 &place) const
{
  constexpr double kLeastVariance = 1e-6;       // of the parts inside
  constexpr double kLeastBeyondVariance = 1e-4; // of the parts beyond the layer that those inside do not tell
  constexpr double kLeastStep = 1e-5;           // as part of the intensities: less is rounding
  const Sums sums = sums_around(place);
  const double w = sums[kW];
  if (!(w > 0))
    return std::nullopt;
  const double h = sums[kH] / w;
  const double b = sums[kB] / w;
  const double g = sums[kG] / w;
  const double hh = sums[kHH] / w - h * h;
  const double hb = sums[kHB] / w - h * b;
  const double hg = sums[kHG] / w - h * g;
  const double bg = sums[kBG] / w - b * g;
  if (!(hh > kLeastVariance))
    return std::nullopt;
  const double bb = sums[kBB] / w - b * b - hb * hb / hh;
  const double beyond = bb > kLeastBeyondVariance ? (bg - hb * hg / hh) / bb : 0;
  const double step = (hg - beyond * hb) / hh;
  if (!(std::abs(step) > kLeastStep * std::abs(g)))
    return std::nullopt;
  const double left_over = sums[kGG] / w - g * g - step * hg - beyond * bg;
  return Contrast{g - step * h - beyond * b, step, beyond, std::sqrt(std::max(left_over, 0.0))};
}

} // namespace volsurf
