// Volumes of one body, as a scanner that averages over each voxel sees it.
#pragma once

#include "volsurf/phantom/body.h"
#include "volsurf/phantom/phantom.h"

namespace volsurf {

/// Noise-free intensities, before bias.
constexpr float kBodySignal = 200;
constexpr float kBodySurroundings = 100;

/// The body, each sample the mean over its voxel, and 1 in the truth where the sample itself is inside. Throws
/// UsageError where an option is out of its range, and Cancelled. Samples of
/// exact bodies are right within 1 % of the contrast.
Phantom make_body_phantom(BodyKind body, const PhantomOptions &options, const Progress &progress = {});

/// How much finer than the grid sample_distance must be for an isosurface to be within 0.02 voxels of the body.
int refinement_for(BodyKind body, const Grid &grid);

/// A body's distance, sampled `finer` times as finely as the grid along each axis, around the body: its zero set is the
/// body's surface, closed along the border of the grid's samples, where values are positive outside. Where the surface
/// is more than two voxels away, values tell only the side. Throws UsageError where the body is not in the grid, and
/// Cancelled.
Volume sample_distance(const SignedDistance &distance, const Grid &grid, int finer, const Progress &progress = {});

} // namespace volsurf
