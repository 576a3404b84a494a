// The watershed by flooding, with regions merged up to a level.
//
// Source: Beare and Lehmann, "The watershed transform in ITK - discussion and new developments", The Insight Journal
// (2006); by itk::MorphologicalWatershedImageFilter.
#pragma once

#include "volsurf/core/progress.h"
#include "volsurf/core/volume.h"

namespace volsurf {

/// The catchment basins of `edge_strength`, after its minima that are at most `level` deep have been filled up: labels
/// 1 .. n on the samples, connected over 26 neighbours, without lines between them. There are as many of them as
/// regions at delta = level, unless a persistence is just that (docs/method.md T2); but a region here consists of
/// samples, in volsurf of cells. One thread; O(samples log samples), 120 bytes per sample and, of noise, up to 440.
/// Throws Cancelled.
LabelVolume morphological_watershed(const Volume &edge_strength, double level, const Progress &progress = {});

} // namespace volsurf
