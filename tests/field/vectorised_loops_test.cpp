// The loops that run on SIMD give the bytes of plain ones. plain_kernels.cpp holds those.
#include "support/fields.h"
#include "support/row_patterns.h"
#include "volsurf/field/row_kernels.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>

using namespace volsurf;
using namespace volsurf::support;

namespace volsurf_plain {

void smooth_row(const float *const *rows, const float *weights, int radius, std::int64_t count, float *out);
void derive_row(const float *const *rows, const float *weights, int radius, std::int64_t count, float *out);
void smooth_and_derive_row(const float *const *rows, const float *smooth, const float *derive, int radius,
                           std::int64_t count, float *smooth_out, float *derive_out);
void difference_row(const float *low, const float *high, float factor, std::int64_t count, float *out);
std::int32_t negative_magnitude_row(const float *gx, const float *gy, const float *gz, std::int64_t count, float *out);
void negate_row(const float *in, std::int64_t count, float *out);
RowPatterns row_patterns(const Index3 &size, const std::vector<float> &values, bool is_infinite, std::int64_t y,
                         std::int64_t z);

} // namespace volsurf_plain

namespace {

using Row = std::vector<float>;

Row random_row(Dice &dice, std::int64_t count, bool with_ties)
{
  Row row;
  for (std::int64_t i = 0; i < count; ++i) {
    if (dice.one_in(20))
      row.push_back(std::numeric_limits<float>::max());
    else
      row.push_back(static_cast<float>(with_ties ? dice.between(0, 3) : dice.between(-1000000, 1000000)) / 7.0F);
  }
  return row;
}

void require_same_bytes(const Row &a, const Row &b)
{
  RC_ASSERT(std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

/// Compares what a call fills. `call(is_plain, out)`.
template <typename Call> void require_same_row(std::int64_t count, Call call)
{
  Row fast(static_cast<std::size_t>(count));
  Row plain(static_cast<std::size_t>(count));
  call(false, fast.data());
  call(true, plain.data());
  require_same_bytes(fast, plain);
}

} // namespace

RC_GTEST_PROP(VectorisedLoops, KernelsGiveTheBytesOfPlainLoops, ())
{
  Dice dice(*random_seed());
  const std::int64_t count = dice.between(1, 200);
  const int radius = static_cast<int>(dice.between(1, 9));
  std::vector<Row> rows;
  std::vector<const float *> starts;
  for (int k = 0; k < 2 * radius + 1; ++k)
    rows.push_back(random_row(dice, count, false));
  for (const Row &row : rows)
    starts.push_back(row.data());
  const Row weights = random_row(dice, radius + 1, false);
  require_same_row(count, [&](bool plain, float *out) {
    (plain ? volsurf_plain::smooth_row : smooth_row)(starts.data(), weights.data(), radius, count, out);
  });
  require_same_row(count, [&](bool plain, float *out) {
    (plain ? volsurf_plain::derive_row : derive_row)(starts.data(), weights.data(), radius, count, out);
  });
  const Row derive_weights = random_row(dice, radius + 1, false);
  Row other(static_cast<std::size_t>(count));
  require_same_row(count, [&](bool plain, float *out) {
    (plain ? volsurf_plain::smooth_and_derive_row : smooth_and_derive_row)(
        starts.data(), weights.data(), derive_weights.data(), radius, count, out, other.data());
  });
  require_same_row(count, [&](bool plain, float *out) {
    (plain ? volsurf_plain::smooth_and_derive_row : smooth_and_derive_row)(
        starts.data(), weights.data(), derive_weights.data(), radius, count, other.data(), out);
  });
}

RC_GTEST_PROP(VectorisedLoops, DifferencesAndMagnitudesGiveTheBytesOfPlainLoops, ())
{
  Dice dice(*random_seed());
  const std::int64_t count = dice.between(1, 200);
  const Row a = random_row(dice, count, false);
  const Row b = random_row(dice, count, false);
  const Row c = random_row(dice, count, true);
  require_same_row(count, [&](bool plain, float *out) {
    (plain ? volsurf_plain::difference_row : difference_row)(a.data(), b.data(), 0.3F, count, out);
  });
  require_same_row(
      count, [&](bool plain, float *out) { (plain ? volsurf_plain::negate_row : negate_row)(c.data(), count, out); });
  std::array<std::int64_t, 2> non_finite{};
  require_same_row(count, [&](bool plain, float *out) {
    non_finite[plain ? 1 : 0] = (plain ? volsurf_plain::negative_magnitude_row
                                       : negative_magnitude_row)(a.data(), b.data(), c.data(), count, out);
  });
  RC_ASSERT(non_finite[0] == non_finite[1]);
}

RC_GTEST_PROP(VectorisedLoops, PatternsOfStarsAreThoseOfPlainLoops, ())
{
  Dice dice(*random_seed());
  const Index3 size{dice.between(2, 600), 3, 3};
  const Row values = random_row(dice, size[0] * size[1] * size[2], true);
  const bool is_infinite = dice.one_in(2);
  const BorderRule border(size, is_infinite ? Exterior::infinite : Exterior::none);
  const std::int64_t y = dice.between(0, 2);
  const std::int64_t z = dice.between(0, 2);
  RC_ASSERT(row_patterns({size, values}, border, y, z) == volsurf_plain::row_patterns(size, values, is_infinite, y, z));
}
