// Loops compiled for several instruction sets, chosen when the program starts.
#pragma once

/// On a function whose loops the compiler turns into SIMD: one binary then runs on any x86-64 and uses AVX2 where there
/// is AVX2. The arithmetic is the same in each version (no fused multiply-add), so the results are too. The sanitizers'
/// run-time is not ready when the version is chosen, so they get the plain one.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&               \
    !defined(__SANITIZE_THREAD__)
#define VOLSURF_VECTORISE __attribute__((target_clones("avx2", "default")))
#else
#define VOLSURF_VECTORISE
#endif
