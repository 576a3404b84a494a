// From components and their sizes to the choice of which to keep.
#pragma once

#include "volsurf/surface/components.h"

namespace volsurf {

/// Numbers components 0 .. sizes.size() - 1 anew, from 1, by decreasing size, ties by their lowest face. O(faces).
Components rank_components(std::vector<ComponentId> of_face, const std::vector<double> &sizes,
                           const std::vector<std::int64_t> &lowest_face, const Keep &keep);

} // namespace volsurf
