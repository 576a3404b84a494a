// An outside witness: GUDHI's cubical complex. In a file of its own, as its headers are large.
#pragma once

#include "support/naive_merge.h"

#include <set>

namespace volsurf::support {

/// The positive finite persistences of dimension 0 of -I, by GUDHI. Its complex takes samples for cells of the highest
/// dimension, which meet over faces, edges and corners: the 26-connectivity of samples.
std::multiset<float> gudhi_persistences(const Field &field);

} // namespace volsurf::support
