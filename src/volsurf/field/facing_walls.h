// How much of a scan's walls face another wall close by: the sign of furrows and folds that its grid hardly holds.
//
// The volume is blurred by one voxel, and its slopes taken from sample to sample. Where a slope is steep, much above
// what noise makes, there is a wall; where two samples further on across it the slope is steep the other way, another
// one faces it. A single number, for a decision: walls further apart than three voxels do not count, nor noise.
#pragma once

#include "volsurf/core/volume.h"

namespace volsurf {

/// The part of the samples on walls, 0 .. 1, that have a facing one; 0 where there is no wall. `noise` is the standard
/// deviation in a sample. The study's balls, tubes and their creases have at most 0.02 of them, whatever the noise, a
/// tube in thick slices 0.05, its cortex and brain 0.11 to 0.16, a shell of 3 voxels 0.25. O(samples), parallel; takes
/// 8 bytes per sample.
double part_of_facing_walls(const Volume &volume, double noise);

} // namespace volsurf
