// Noise for phantoms and tests.
#pragma once

#include "volsurf/core/volume.h"

#include <cstdint>
#include <string_view>

namespace volsurf {

enum class NoiseKind {
  kNone,
  kImpulse,  ///< a sample becomes, with probability `amount`, uniform over the volume's own range of values
  kGaussian, ///< adds a normal value of standard deviation `amount`
  kRician    ///< |signal + complex normal value|, `amount` the deviation of each of its two parts: magnitude images
};

struct NoiseOptions {
  NoiseKind kind = NoiseKind::kNone;
  double amount = 0; ///< a fraction 0 .. 1 for impulses, else a standard deviation in intensity, 0 or more
  std::uint64_t seed = 1;
};

/// Changes the volume in place. What a sample gets depends on the seed and its linear index only, so the result is the
/// same for any number of threads. Gaussian noise may leave the scan's range; nothing is clamped here.
/// Throws UsageError where the amount is out of its range.
void add_noise(Volume &volume, const NoiseOptions &options);

/// The noise that a text names: "none", "impulse:2%", "gaussian:5%", "rician:40". For impulses the number is the
/// fraction, plain or in percent; for the others a standard deviation, in intensity or in percent of `contrast`.
/// Throws UsageError.
NoiseOptions parse_noise(std::string_view text, double contrast);

} // namespace volsurf
