// A field's values as a scan.
#pragma once

#include "support/naive_merge.h"

#include "volsurf/core/volume.h"

namespace volsurf::support {

inline Volume volume_of(const Field &field)
{
  Volume volume;
  volume.grid.size = field.size;
  volume.samples = field.values;
  return volume;
}

} // namespace volsurf::support
