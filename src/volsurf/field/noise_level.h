// How strong the noise of a volume is, and what the gradient makes of it.
//
// The samples are differenced twice along each axis, which leaves white noise and little else: of edges only corners
// remain. The median of the absolute values gives the standard deviation, whatever a minority of the samples holds.
//
// Source: the median absolute deviation as Donoho and Johnstone use it on the finest details of a signal (1994); the
// difference is that of Immerkaer's noise estimate (1996), in three dimensions.
#pragma once

#include "volsurf/field/gradient.h"

namespace volsurf {

/// Standard deviations. White noise of s_g in a component of the gradient makes walls, as persistence measures them, of
/// at most 1.1 to 1.7 s_g; 99.9 % are below 1.15 s_g.
struct NoiseLevel {
  double volume = 0;   ///< of the samples, in intensity
  double gradient = 0; ///< s_g: of a component of the gradient, in intensity per mm; of an edge map the same as above
};

/// That of the samples: at most 2^20 of them, spread over the volume, are looked at; those where nothing at all changes
/// (masked background, padding) are left out. Noise that is correlated over neighbouring samples is underestimated.
/// O(samples looked at).
double measure_sample_noise(const Volume &volume);

/// That and what the gradient makes of it. As above.
NoiseLevel measure_noise(const Volume &volume, const EdgeField &field);

} // namespace volsurf
