#include "volsurf/core/differences.h"

#include "support/fields.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr std::uint64_t kUntouched = 0x5A5A5A5A5A5A5A5A;

std::vector<std::uint64_t> plain_differences(const std::vector<std::uint32_t> &a, const std::vector<std::uint32_t> &b)
{
  std::vector<std::uint64_t> words((a.size() + 63) / 64);
  for (std::size_t x = 0; x < a.size(); ++x)
    words[x / 64] |= static_cast<std::uint64_t>(a[x] != b[x]) << (x % 64);
  std::replace(words.begin(), words.end(), std::uint64_t{0}, kUntouched);
  return words;
}

} // namespace

RC_GTEST_PROP(MarkDifferences, SetsTheBitsOfThosePlacesAndTouchesNoOtherWord, ())
{
  Dice dice(*random_seed());
  std::vector<std::uint32_t> a(static_cast<std::size_t>(dice.between(0, 300)));
  std::generate(a.begin(), a.end(), [&] { return static_cast<std::uint32_t>(dice.between(0, 0xFFFFFFFF)); });
  std::vector<std::uint32_t> b = a;
  const std::int64_t one_in = dice.between(1, 200);
  for (std::uint32_t &number : b)
    if (dice.one_in(one_in))
      number ^= std::uint32_t{1} << dice.between(0, 31);
  std::vector<std::uint64_t> words((a.size() + 63) / 64, kUntouched);
  mark_differences(a.data(), b.data(), static_cast<std::int64_t>(a.size()), words.data());
  RC_ASSERT(words == plain_differences(a, b));
}
