// The integer types of the stages. Samples, cells and faces are counted in 64 bits, because a volume may have
// more than 2^31 samples; basins, regions and components are few enough for 32.
#pragma once

#include <cstdint>

namespace volsurf {

using SampleId = std::int64_t;     ///< linear index of a sample, x fastest
using CellId = std::int64_t;       ///< linear index of a cell on the cell grid (one less per axis), x fastest
using BasinId = std::uint32_t;     ///< a tree of zero-persistence edges, numbered by root cell
using RegionId = std::uint32_t;    ///< 1 is the region with most cells; 0 stands for no region
using ComponentId = std::uint32_t; ///< 1 is the component of highest rank; 0 stands for none
using PointId = std::uint32_t;     ///< a point of a Mesh

constexpr RegionId kNoRegion = 0;

} // namespace volsurf
