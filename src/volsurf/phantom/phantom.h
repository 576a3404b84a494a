// A head as a T1-weighted scanner sees it, with the truth beside it.
#pragma once

#include "volsurf/core/progress.h"
#include "volsurf/core/volume.h"
#include "volsurf/phantom/head.h"

#include <array>
#include <cstdint>

namespace volsurf {

/// Noise-free intensity of each Tissue at the height of the brain, as a 12-bit T1-weighted scan with fat suppression
/// has them. Grey matter is so near to white matter that their wall is far weaker than the one of the brain.
constexpr std::array<float, kTissueCount> kTissueIntensity{20, 460, 120, 220, 850, 1050, 220, 540};

/// Intensities lie in 0 .. kLargestIntensity.
constexpr float kLargestIntensity = 4095;

/// Brightest minus darkest tissue: what noise and walls are measured against.
constexpr float kTissueContrast = 1030;

struct PhantomOptions {
  Index3 size{128, 128, 128}; ///< samples per axis, at least 2
  Vec3 spacing_mm{1.6, 1.6, 1.6};
  double bias = 0.2;         ///< 0 .. 1: the bias field runs from 1 - bias/2 to 1 + bias/2
  std::uint64_t anatomy = 1; ///< seed of the folds and of the bias field
  Vec3 offset_mm{};          ///< of a single body, from the middle of the volume; the head stays
  bool with_truth = true;    ///< false leaves the labels empty, to save their memory
};

struct Phantom {
  Volume volume;     ///< free of noise; not rounded to integers
  LabelVolume truth; ///< the Tissue at each sample's centre, on the volume's grid
};

/// The grid that the options ask for, its middle at the origin. Throws UsageError where an option is out of its range.
Grid phantom_grid(const PhantomOptions &options);

/// Noise-free intensity of a tissue at a height of the head's frame, before bias. As under a coil that was made
/// for the brain, what lies around the brain fades downwards: at the lower end of the head, skin, muscle, bone and
/// fluid are as dark as air. So the walls between them and the air have a weak point, and they are one region with it.
/// The brain stem is not: it stays bright to the end, which is a simplification.
double tissue_signal(Tissue tissue, double height_mm);

/// The head, centred in the volume, x to the left, y to the back, z up (LPS). It needs kHeadExtentMm on each axis; a
/// smaller volume cuts it, as a small field of view does. A sample near a wall mixes the tissues of both sides, by the
/// part that a voxel's width along the wall's normal has on each side.
/// Throws UsageError where an option is out of its range, and Cancelled.
Phantom make_head_phantom(const PhantomOptions &options, const Progress &progress = {});

/// Equal spacing on all axes with which the whole head fits into `size` samples.
Vec3 spacing_that_fits_the_head(const Index3 &size);

} // namespace volsurf
