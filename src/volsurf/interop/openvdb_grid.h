// Label and scalar volumes as OpenVDB grids.
#pragma once

#include "volsurf/core/provenance.h"
#include "volsurf/core/volume.h"
#include "volsurf/interop/frame.h"

#include <filesystem>

namespace volsurf {

/// Writes two grids: "regions" (Int32Grid; 0 is background and inactive) and "gradient_magnitude" (FloatGrid, a fog
/// volume). Index space starts at 0; each grid's transform leads to world millimetres in `frame`. Both carry SPACE,
/// Version, Source and Options as metadata. The same input makes the same bytes. Throws OutputError.
void write_vdb(const LabelVolume &regions, const Volume &gradient_magnitude, const std::filesystem::path &file,
               const Provenance &provenance, Frame frame);

} // namespace volsurf
