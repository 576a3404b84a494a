// The surface where the volume has one value, from the volume to the files.
#pragma once

#include "volsurf/pipeline/surface_writer.h"

namespace volsurf {

/// Makes the isosurface at settings.iso, keeps the components that settings ask for, smooths them where settings say
/// so, and writes them. Throws EmptyResult where no surface has this value, else as make_surfaces().
void make_isosurface(const Volume &volume, const Settings &settings, const SurfaceSink &sink);

} // namespace volsurf
