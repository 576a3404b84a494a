// Where an edge of the volume lies on a line, as the search for it says and sub-voxel placement takes it.
#pragma once

namespace volsurf {

struct LocatedEdge {
  double way_mm = 0;   ///< along the line
  double error_mm = 0; ///< sd of the way, from the noise
};

} // namespace volsurf
