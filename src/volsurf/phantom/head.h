// The anatomy of the head phantom: bodies given by signed distances, in millimetres.
#pragma once

#include "volsurf/core/grid.h"

#include <array>
#include <cstdint>

namespace volsurf {

/// Values of the truth volume.
enum class Tissue : std::uint32_t { kAir, kScalp, kSkull, kCsf, kGrey, kWhite, kVentricle, kMuscle };
constexpr int kTissueCount = 8;

constexpr bool is_brain(Tissue tissue)
{
  return tissue == Tissue::kGrey || tissue == Tissue::kWhite || tissue == Tissue::kVentricle;
}

/// The bodies from the outside inwards. Where two overlap, the later one counts, so a point's tissue is that of the
/// last body it lies in.
constexpr std::array<Tissue, 8> kBodyTissues{Tissue::kScalp, Tissue::kMuscle, Tissue::kSkull, Tissue::kCsf,
                                             Tissue::kGrey,  Tissue::kWhite,  Tissue::kGrey,  Tissue::kVentricle};

/// Signed distance to each body of kBodyTissues, negative inside. True to first order near the surfaces; elsewhere only
/// the sign counts.
using BodyDistances = std::array<double, kBodyTissues.size()>;

/// A plane wave: direction times 2 pi over the wavelength (per mm), and phase.
struct Wave {
  Vec3 wave_vector;
  double phase;
};

/// The random wave whose zero set places the sulci: one wavelength in all directions gives folds of even width that
/// turn and branch as a cortex does.
using FoldPattern = std::array<Wave, 16>;

/// The same pattern for the same seed. Only the folds depend on it; fissures, ventricles and the skull stay.
FoldPattern make_fold_pattern(std::uint64_t seed);

/// Distances at a point of the head's frame: LPS directions (x to the left, y to the back, z up), the origin at the
/// middle of a cube of kHeadExtentMm that holds the head. The neck and the brain stem go on below it without end.
BodyDistances head_distances(const FoldPattern &folds, const Vec3 &point);

constexpr double kHeadExtentMm = 204.8;

} // namespace volsurf
