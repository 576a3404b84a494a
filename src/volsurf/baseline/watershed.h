// The watershed by flooding, with regions merged up to a level.
//
// Source: Beare and Lehmann, "The watershed transform in ITK - discussion and new developments", The Insight Journal
// (2006); by itk::MorphologicalWatershedImageFilter.
#pragma once

#include "volsurf/core/progress.h"
#include "volsurf/core/volume.h"

namespace volsurf {

/// The catchment basins of `edge_strength`, its minima less deep than `level` filled up before: labels 1 .. n on the
/// samples, connected over 26 neighbours, without lines between them. There are as many of them as regions at
/// delta = level (docs/method.md T2), but each sample belongs to one, where volsurf's regions consist of cells. One
/// thread; O(samples log samples), 30 and more bytes per sample. Throws Cancelled.
LabelVolume morphological_watershed(const Volume &edge_strength, double level, const Progress &progress = {});

} // namespace volsurf
