// An iso-value from the histogram: the one that separates two classes of samples best.
//
// Source: Otsu, "A threshold selection method from gray-level histograms", IEEE Transactions on Systems, Man, and
// Cybernetics 9 (1979); by itk::OtsuThresholdCalculator.
#pragma once

#include "volsurf/core/volume.h"

namespace volsurf {

/// The border between two of 256 bins over the range of the samples; of a volume of one value, that value. O(samples).
double otsu_value(const Volume &volume);

} // namespace volsurf
