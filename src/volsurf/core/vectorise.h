// Loops compiled for several instruction sets, chosen when the program starts.
#pragma once

#ifdef __SSE__
#include <xmmintrin.h>
#endif

/// On a function whose loops the compiler turns into SIMD: one binary then runs on any x86-64 and uses AVX2 where there
/// is AVX2, and on processors with AVX-512 what that has for vectors of the same width: masks, and logic of three
/// operands. The arithmetic is the same in each version (no fused multiply-add), so the results are too. The
/// sanitizers' run-time is not ready when the version is chosen, so they get the plain one.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&               \
    !defined(__SANITIZE_THREAD__)
#define VOLSURF_VECTORISE __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define VOLSURF_VECTORISE
#endif

/// On what such a function calls with lanes: it must become part of each version, not a function of the plain one.
#define VOLSURF_LANES_INLINE __attribute__((always_inline)) inline

// So lanes are never handed from one compiled function to another, which is what this warning is about.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace volsurf {

/// Eight numbers at a time, at any address. Where there are no registers of that width the compiler takes two halves.
/// Comparisons give masks, and mask ? a : b chooses lane by lane, so that one template serves single numbers, too.
using Float32x8 = float __attribute__((vector_size(32), aligned(4), may_alias));
using Float64x4 = double __attribute__((vector_size(32), aligned(4), may_alias));
using UInt32x8 = unsigned __attribute__((vector_size(32), aligned(4), may_alias));
using UInt64x4 = unsigned long long __attribute__((vector_size(32), aligned(4), may_alias));
using UInt8x32 = unsigned char __attribute__((vector_size(32), aligned(4), may_alias));
using Mask32x8 = decltype(UInt32x8{} != 0);
constexpr int kLanes = 8;

/// The lanes, or the single number, that begin at an address.
template <typename Lanes, typename Number> VOLSURF_LANES_INLINE const Lanes &lanes_at(const Number *address)
{
  return *reinterpret_cast<const Lanes *>(address);
}
template <typename Lanes, typename Number> VOLSURF_LANES_INLINE Lanes &lanes_at(Number *address)
{
  return *reinterpret_cast<Lanes *>(address);
}

/// All ones in the lanes of a set, bit i for lane i.
VOLSURF_LANES_INLINE Mask32x8 lanes_of_set(unsigned set)
{
  constexpr UInt32x8 kBits = {1, 2, 4, 8, 16, 32, 64, 128};
  return (kBits & set) != 0;
}

/// The set of lanes that a comparison has filled with ones.
VOLSURF_LANES_INLINE unsigned set_of_lanes(const Mask32x8 &mask)
{
#ifdef __SSE__
  const auto &lanes = reinterpret_cast<const Float32x8 &>(mask);
  const auto low = static_cast<__m128>(__builtin_shufflevector(lanes, lanes, 0, 1, 2, 3));
  const auto high = static_cast<__m128>(__builtin_shufflevector(lanes, lanes, 4, 5, 6, 7));
  return static_cast<unsigned>(_mm_movemask_ps(low) | _mm_movemask_ps(high) << 4);
#else
  unsigned set = 0;
  for (int i = 0; i < kLanes; ++i)
    set |= (mask[i] != 0 ? 1U : 0U) << i;
  return set;
#endif
}

} // namespace volsurf
