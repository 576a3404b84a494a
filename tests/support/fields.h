// Small random fields for property tests, shrunk by cropping.
#pragma once

#include "support/naive_merge.h"

#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <random>

namespace volsurf::support {

inline void showValue(const Field &field, std::ostream &out) // NOLINT(readability-identifier-naming): RapidCheck's name
{
  out << field.size[0] << " x " << field.size[1] << " x " << field.size[2] << ":";
  for (const float value : field.values)
    out << ' ' << value;
}

/// Uniform integers. RapidCheck's own ranges start narrow and widen with the case's number, which would spend half of
/// the cases on fields of 2 x 2 x 2.
class Dice {
public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  /// low .. high
  std::int64_t between(std::int64_t low, std::int64_t high)
  {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool one_in(std::int64_t n) { return between(1, n) == 1; }

private:
  std::mt19937_64 engine_;
};

/// Any seed, from the first case on.
inline rc::Gen<std::uint64_t> random_seed()
{
  return rc::gen::noShrink(
      rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::uint64_t>(0, std::numeric_limits<std::uint64_t>::max())));
}

inline SampleId sample_at(const Field &field, const Index3 &p)
{
  return p[0] + field.size[0] * (p[1] + field.size[1] * p[2]);
}

/// Calls visit(position, sample) for each sample in order.
template <typename Visit> void for_each_sample(const Index3 &size, Visit visit)
{
  SampleId sample = 0;
  for (std::int64_t z = 0; z < size[2]; ++z)
    for (std::int64_t y = 0; y < size[1]; ++y)
      for (std::int64_t x = 0; x < size[0]; ++x)
        visit(Index3{x, y, z}, sample++);
}

/// The samples around one, itself left out.
inline std::vector<SampleId> neighbours_26(const Index3 &size, const Index3 &p)
{
  std::vector<SampleId> result;
  for_each_sample({3, 3, 3}, [&](const Index3 &step, SampleId) {
    const Index3 q{p[0] + step[0] - 1, p[1] + step[1] - 1, p[2] + step[2] - 1};
    for (int axis = 0; axis < 3; ++axis)
      if (q[axis] < 0 || q[axis] >= size[axis])
        return;
    if (q != p)
      result.push_back(q[0] + size[0] * (q[1] + size[1] * q[2]));
  });
  return result;
}

inline Field crop(const Field &field, int axis, bool drop_first)
{
  Field result{field.size, {}};
  --result.size[axis];
  for_each_sample(result.size, [&](Index3 p, SampleId) {
    p[axis] += drop_first ? 1 : 0;
    result.values.push_back(field.values[sample_at(field, p)]);
  });
  return result;
}

inline rc::Seq<Field> crops(const Field &field)
{
  std::vector<Field> smaller;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool drop_first : {true, false})
      if (field.size[axis] > 2)
        smaller.push_back(crop(field, axis, drop_first));
  return rc::seq::fromContainer(smaller);
}

/// How the values of a field are made.
enum class FieldKind {
  distinct,      ///< nearly no ties
  levels,        ///< plateaus of two to four levels
  smooth,        ///< waves
  steps,         ///< waves, rounded down
  peaks,         ///< few high samples over low ones: many basins, which meet in the stars of the low ones
  tied_peaks,    ///< few high samples of a few levels over a plateau
  blocks,        ///< plateaus of 2 x 2 x 2 samples
  planted_stars, ///< samples just above most of their 26 neighbours: deep newborn cells
  constant,
};
constexpr int kFieldKinds = 9;

inline float wave_at(const Index3 &p, const std::array<double, 4> &wave)
{
  return static_cast<float>(std::sin(wave[0] * static_cast<double>(p[0]) + wave[3]) +
                            std::sin(wave[1] * static_cast<double>(p[1])) +
                            std::cos(wave[2] * static_cast<double>(p[2])));
}

/// Sets some samples to the value of one of their largest neighbours, or just above it.
inline void plant_stars(Field &field, Dice &dice)
{
  for (auto stars = dice.between(1, 6); stars > 0; --stars) {
    const Index3 p{dice.between(0, field.size[0] - 1), dice.between(0, field.size[1] - 1),
                   dice.between(0, field.size[2] - 1)};
    std::vector<float> around;
    for (const SampleId neighbour : neighbours_26(field.size, p))
      around.push_back(field.values[neighbour]);
    std::sort(around.rbegin(), around.rend());
    const float chosen = around[static_cast<std::size_t>(dice.between(0, 5))];
    field.values[sample_at(field, p)] = dice.one_in(3) ? chosen : chosen + 1.0F / 128.0F;
  }
}

inline float field_value(FieldKind kind, const Index3 &p, const std::array<double, 4> &wave, std::int64_t parameter,
                         Dice &dice)
{
  const bool high = dice.between(0, 99) < 5 * parameter;
  switch (kind) {
  case FieldKind::levels:
    return -static_cast<float>(dice.between(0, 1 + parameter % 3));
  case FieldKind::smooth:
    return wave_at(p, wave) - 4.0F;
  case FieldKind::steps:
    return std::floor(2.0F * wave_at(p, wave)) - 8.0F;
  case FieldKind::peaks:
    return static_cast<float>(dice.between(0, 999)) / 64.0F - (high ? 16.0F : 48.0F);
  case FieldKind::tied_peaks:
    return high ? -static_cast<float>(dice.between(0, 5)) : -6.0F;
  case FieldKind::constant:
    return -1.0F;
  default:
    return -static_cast<float>(dice.between(0, 999)) / 64.0F;
  }
}

inline void make_blocks(Field &field)
{
  for_each_sample(field.size, [&](const Index3 &p, SampleId sample) {
    field.values[sample] = field.values[sample_at(field, {p[0] & ~1, p[1] & ~1, p[2] & ~1})];
  });
}

inline Field make_field(std::uint64_t seed, std::int64_t max_size)
{
  Dice dice(seed);
  // A constant field has little to say.
  const auto kind = static_cast<FieldKind>(dice.one_in(50) ? kFieldKinds - 1 : dice.between(0, kFieldKinds - 2));
  Field field{{dice.between(2, max_size), dice.between(2, max_size), dice.between(2, max_size)}, {}};
  if (dice.one_in(4))
    field.size[static_cast<std::size_t>(dice.between(0, 2))] = 2;
  else if (max_size >= 6 && dice.one_in(4))
    field.size[0] = dice.between(9, 20); // rows that SIMD takes in several steps
  std::array<double, 4> wave{};
  for (double &w : wave)
    w = 0.01 * static_cast<double>(dice.between(20, 300));
  const std::int64_t parameter = dice.between(1, 8);
  const FieldKind start = kind == FieldKind::planted_stars && dice.one_in(2) ? FieldKind::peaks : kind;
  for_each_sample(field.size, [&](const Index3 &p, SampleId) {
    field.values.push_back(field_value(start, p, wave, parameter, dice));
  });
  if (kind == FieldKind::blocks)
    make_blocks(field);
  if (kind == FieldKind::planted_stars)
    plant_stars(field, dice);
  return field;
}

/// A field with 2 .. max_size samples per axis, or, from a max_size of 6 on, with up to 20 along x.
inline rc::Gen<Field> random_field(std::int64_t max_size = 6)
{
  const auto fields =
      rc::gen::noShrink(rc::gen::map(random_seed(), [max_size](auto seed) { return make_field(seed, max_size); }));
  return rc::gen::shrink(fields, [](const Field &field) { return crops(field); });
}

} // namespace volsurf::support
