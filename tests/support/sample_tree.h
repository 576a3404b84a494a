// Join trees of samples by plain union-find: they know nothing of cells, faces or the order K.
#pragma once

#include "support/naive_merge.h"

#include <set>

namespace volsurf::support {

/// The positive persistences of the superlevel sets of the samples, where samples at most one apart on each axis are
/// neighbours (26-connectivity). With Exterior::infinite all samples at the border are neighbours of one of value
/// +infinity.
std::multiset<float> sample_persistences(const Field &field, Exterior exterior);

/// The components of the samples with I >= level: for each the smallest sample of its component, -1 below the level.
std::vector<SampleId> superlevel_components(const Field &field, float level);

} // namespace volsurf::support
