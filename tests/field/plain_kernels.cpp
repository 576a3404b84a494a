// The loops made for SIMD once more, for the processor that every x86-64 is, in a namespace of their own.
#define volsurf volsurf_plain // NOLINT(readability-identifier-naming): a namespace
#include "volsurf/core/vectorise.h"

#undef VOLSURF_VECTORISE
#define VOLSURF_VECTORISE

#include "volsurf/field/row_kernels.cpp"      // NOLINT(bugprone-suspicious-include)
#include "volsurf/topology/newborn.cpp"       // NOLINT(bugprone-suspicious-include)
#include "volsurf/topology/sample_order.cpp"  // NOLINT(bugprone-suspicious-include)
#include "volsurf/topology/star_patterns.cpp" // NOLINT(bugprone-suspicious-include)
#include "volsurf/topology/star_tables.cpp"   // NOLINT(bugprone-suspicious-include)

#include "support/row_patterns.h"

namespace volsurf {

support::RowPatterns row_patterns(const Index3 &size, const std::vector<float> &values, bool is_infinite,
                                  std::int64_t y, std::int64_t z)
{
  const BorderRule border(size, is_infinite ? Exterior::infinite : Exterior::none);
  return support::row_patterns({size, values}, border, y, z);
}

} // namespace volsurf
