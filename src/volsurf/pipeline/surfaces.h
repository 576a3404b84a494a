// From the regions to the surfaces: boundary, components, surface, smoothing, check, file.
#pragma once

#include "volsurf/pipeline/selection.h"
#include "volsurf/pipeline/surface_writer.h"

namespace volsurf {

/// A volume, merged and cut at one delta.
struct CutVolume {
  const Volume &volume;
  const Grid &corners; ///< of the cells
  double sigma_mm;     ///< of its gradient
  const RegionMerge &merge;
  const Regions &regions;
  RegionId background;
};

/// Makes the surfaces that the selection asks for and writes them, each as soon as it is complete: one, one per kept
/// component of it, or one per region. Throws UsageError where a split makes too many files or asks for the surface of
/// the background, OutputError, and Cancelled.
void make_surfaces(const CutVolume &volume, const Settings &settings, const Selection &selection,
                   const SurfaceSink &sink);

} // namespace volsurf
