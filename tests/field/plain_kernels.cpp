// The loops made for SIMD once more, for the processor that every x86-64 is, in a namespace of their own.
#define volsurf volsurf_plain // NOLINT(readability-identifier-naming): a namespace
#include "volsurf/core/vectorise.h"

#undef VOLSURF_VECTORISE
#define VOLSURF_VECTORISE

#include "volsurf/field/row_kernels.cpp" // NOLINT(bugprone-suspicious-include)
#include "volsurf/topology/newborn.cpp"  // NOLINT(bugprone-suspicious-include)
