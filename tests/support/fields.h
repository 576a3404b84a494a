// Small random fields for property tests, shrunk by cropping.
#pragma once

#include "support/naive_merge.h"

#include <rapidcheck.h>

#include <cmath>
#include <ostream>

namespace volsurf::support {

inline void showValue(const Field &field, std::ostream &out) // NOLINT(readability-identifier-naming): RapidCheck's name
{
  out << field.size[0] << " x " << field.size[1] << " x " << field.size[2] << ":";
  for (const float value : field.values)
    out << ' ' << value;
}

inline Field crop(const Field &field, int axis, bool drop_first)
{
  Field result{field.size, {}};
  --result.size[axis];
  for (std::int64_t z = 0; z < result.size[2]; ++z)
    for (std::int64_t y = 0; y < result.size[1]; ++y)
      for (std::int64_t x = 0; x < result.size[0]; ++x) {
        Index3 p{x, y, z};
        p[axis] += drop_first ? 1 : 0;
        result.values.push_back(field.values[p[0] + field.size[0] * (p[1] + field.size[1] * p[2])]);
      }
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

/// Values of five kinds: many distinct ones, plateaus of a few levels, constant, smooth, and smooth in steps.
inline float field_value(int kind, int random, const Index3 &p, const std::array<double, 4> &wave)
{
  const double smooth = std::sin(wave[0] * static_cast<double>(p[0]) + wave[3]) +
                        std::sin(wave[1] * static_cast<double>(p[1])) + std::cos(wave[2] * static_cast<double>(p[2]));
  switch (kind) {
  case 0:
    return -static_cast<float>(random) / 64.0F;
  case 1:
    return -static_cast<float>(random % 3);
  case 2:
    return -1.0F;
  case 3:
    return static_cast<float>(smooth) - 4.0F;
  default:
    return static_cast<float>(std::floor(2.0 * smooth)) - 8.0F;
  }
}

/// A field of `kind` (0 .. 4, see field_value) with 2 .. max_size samples per axis.
inline rc::Gen<Field> random_field(std::int64_t max_size = 6)
{
  return rc::gen::shrink(
      rc::gen::exec([max_size] {
        const int kind = *rc::gen::inRange(0, 5);
        Field field{{*rc::gen::inRange<std::int64_t>(2, max_size + 1), *rc::gen::inRange<std::int64_t>(2, max_size + 1),
                     *rc::gen::inRange<std::int64_t>(2, max_size + 1)},
                    {}};
        std::array<double, 4> wave{};
        for (double &w : wave)
          w = 0.01 * *rc::gen::inRange(20, 300);
        const auto count = static_cast<std::size_t>(field.size[0] * field.size[1] * field.size[2]);
        const auto randoms = *rc::gen::container<std::vector<int>>(count, rc::gen::inRange(0, 1000));
        for (std::int64_t z = 0, i = 0; z < field.size[2]; ++z)
          for (std::int64_t y = 0; y < field.size[1]; ++y)
            for (std::int64_t x = 0; x < field.size[0]; ++x, ++i)
              field.values.push_back(field_value(kind, randoms[static_cast<std::size_t>(i)], {x, y, z}, wave));
        return field;
      }),
      crops);
}

} // namespace volsurf::support
