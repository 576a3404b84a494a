// Random numbers that are a function of a seed and a position, so that threads and slabs cannot change them. The
// distributions of <random> differ between standard libraries; these do not.
#pragma once

#include <cstdint>

namespace volsurf {

/// The output function of splitmix64 (Steele, Lea and Flood, 2014).
constexpr std::uint64_t splitmix64_mix(std::uint64_t z)
{
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// The position-th number, from 0, of the splitmix64 sequence that `seed` selects.
constexpr std::uint64_t random_bits(std::uint64_t seed, std::uint64_t position)
{
  // The seed is mixed first: seeds 1 and 2 must not give one sequence shifted by a place.
  return splitmix64_mix(splitmix64_mix(seed) + (position + 1) * 0x9e3779b97f4a7c15ULL);
}

/// Uniform in [0, 1), a multiple of 2^-53.
constexpr double random_uniform(std::uint64_t seed, std::uint64_t position)
{
  return static_cast<double>(random_bits(seed, position) >> 11) * 0x1p-53;
}

} // namespace volsurf
