// Scans of bodies whose surface is known, each sample the mean over its voxel.
#pragma once

#include "support/fields.h"

#include "volsurf/core/volume.h"

namespace volsurf::support {

/// The mean is over so many parts of the voxel along each axis. `distance` is the signed distance in voxels to the
/// body, negative inside, or no further from 0 than that.
template <typename Distance>
Volume scan_of_body(const Index3 &size, Distance distance, float outside = 100, float inside = 200,
                    int parts_per_axis = 5)
{
  Volume volume;
  volume.grid.size = size;
  for_each_sample(size, [&](const Index3 &p, SampleId) {
    const Vec3 centre{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    int parts = distance(centre) < 0 ? parts_per_axis * parts_per_axis * parts_per_axis : 0;
    if (std::abs(distance(centre)) < 1) {
      parts = 0;
      for_each_sample({parts_per_axis, parts_per_axis, parts_per_axis}, [&](const Index3 &part, SampleId) {
        Vec3 place = centre;
        for (int axis = 0; axis < 3; ++axis)
          place[axis] += (static_cast<double>(part[axis]) + 0.5) / parts_per_axis - 0.5;
        parts += distance(place) < 0;
      });
    }
    const float share =
        static_cast<float>(parts) / static_cast<float>(parts_per_axis * parts_per_axis * parts_per_axis);
    volume.samples.push_back(outside + (inside - outside) * share);
  });
  return volume;
}

} // namespace volsurf::support
