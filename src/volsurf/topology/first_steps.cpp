#include "volsurf/topology/first_steps.h"

#include "volsurf/core/vectorise.h"

#include <limits>

namespace volsurf {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A neighbour: its value, and the code of the step to it.
template <typename Values, typename Codes> struct Neighbours {
  Values values;
  Codes steps;
};

/// The neighbours across the axis on the side of the first corner. Their value is -infinity where they are newborn at
/// v, too: seen from them, v is at the other side of the axis.
template <typename Values, typename Codes>
VOLSURF_LANES_INLINE Neighbours<Values, Codes> neighbours_across(int axis, const Codes &corners, const CellRow &low,
                                                                 const CellRow &high, std::int64_t x)
{
  const auto is_high = (corners & (1U << axis)) != 0;
  const Codes neighbour_corners = is_high ? lanes_at<Codes>(high.corners + x) : lanes_at<Codes>(low.corners + x);
  const Values values = is_high ? lanes_at<Values>(high.values + x) : lanes_at<Values>(low.values + x);
  const Values newborn = Values{} - kInfinity;
  const Codes step = Codes{} + static_cast<BasinId>(2 * axis);
  return {neighbour_corners != (corners ^ (1U << axis)) ? values : newborn, is_high ? step + 1 : step};
}

template <typename Values, typename Codes>
VOLSURF_LANES_INLINE void choose_steps(const CellRows &rows, std::int64_t x, BasinId *codes)
{
  const Codes corners = lanes_at<Codes>(rows.centre.corners + x);
  const CellRow left{rows.centre.values - 1, rows.centre.corners - 1};
  const CellRow right{rows.centre.values + 1, rows.centre.corners + 1};
  const auto across_x = neighbours_across<Values>(0, corners, left, right, x);
  const auto across_y = neighbours_across<Values>(1, corners, rows.low_y, rows.high_y, x);
  const auto across_z = neighbours_across<Values>(2, corners, rows.low_z, rows.high_z, x);
  const auto y_is_larger = across_y.values > across_x.values;
  const Values best_xy = y_is_larger ? across_y.values : across_x.values;
  const Codes step_xy = y_is_larger ? across_y.steps : across_x.steps;
  const auto z_is_larger = across_z.values > best_xy;
  const Values best = z_is_larger ? across_z.values : best_xy;
  const Codes step = z_is_larger ? across_z.steps : step_xy;

  const Codes to_exterior = Codes{} + static_cast<BasinId>(kToExterior);
  const Codes none = Codes{} + static_cast<BasinId>(kNoStep);
  const Codes inner = best == Values{} - kInfinity ? none : step;
  lanes_at<Codes>(codes + x) = kFirstStepCode + (best == Values{} + kInfinity ? to_exterior : inner);
}

} // namespace

VOLSURF_VECTORISE
void first_steps(const CellRows &rows, std::int64_t count, BasinId *codes)
{
  for (std::int64_t x = 0; count < kLanes && x < count; ++x)
    choose_steps<float, BasinId>(rows, x, codes);
  for (std::int64_t x = 0; count >= kLanes && x < count; x += kLanes)
    choose_steps<Float32x8, UInt32x8>(rows, x + kLanes <= count ? x : count - kLanes, codes);
}

} // namespace volsurf
