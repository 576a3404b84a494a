// Single bodies whose true surface is known: what a study of accuracy measures against.
#pragma once

#include "volsurf/core/grid.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace volsurf {

enum class BodyKind {
  kSphere, ///< of radius 0.3 E, where E is the shortest side of the volume
  kTorus,  ///< a tube of radius 0.1 E round a circle of radius 0.25 E, tilted
  kBlobs,  ///< two balls of radius 0.2 E that touch: they share one voxel's width, so that they are one body
  kShell,  ///< a ball of radius 0.3 E, hollow: its wall is 3 voxels (of the smallest spacing) thick
  kCortex  ///< the brain of the head phantom by itself, where the head has it and as large
};

/// Signed distance to a body's surface at a place in the world: millimetres, negative inside. Exact but for the
/// cortex, where it is true to first order near the surface and elsewhere only its sign counts.
using SignedDistance = std::function<double(const Vec3 &)>;

/// Bodies sit a fraction of a voxel off the middle of the grid, so that no sample has a place of its own by symmetry.
/// `anatomy` is the seed of the cortex's folds. `offset_mm`, in the world, moves the body from there: far enough, and
/// the volume's border cuts it.
SignedDistance body_distance(BodyKind body, const Grid &grid, std::uint64_t anatomy, const Vec3 &offset_mm = {});

/// The body of this name: "sphere", "torus", "blobs", "shell" or "cortex"; nothing for "head". Throws UsageError.
std::optional<BodyKind> parse_body(std::string_view name);

} // namespace volsurf
