// The isosurface as CGAL's 3D surface mesher makes it: well-shaped triangles by Delaunay refinement.
//
// Source: Boissonnat and Oudot, "Provably good sampling and meshing of surfaces", Graphical Models 67 (2005); by
// CGAL::Surface_mesher. That part of CGAL is under the GPL, so it is built only where VOLSURF_WITH_CGAL asks for it.
#pragma once

#include "volsurf/core/mesh.h"
#include "volsurf/core/progress.h"
#include "volsurf/core/volume.h"

namespace volsurf {

/// Whether this program holds the mesher.
bool has_cgal_mesher();

/// Lengths are in voxels: one is the smallest spacing.
struct CgalMesherOptions {
  double smallest_angle_degrees = 30;  ///< of a triangle; beyond 30 the refinement need not end
  double facet_radius = 1;             ///< at most, of the ball around a triangle with its centre on the surface
  double facet_distance = 0.1;         ///< at most, from the middle of a triangle to the surface
  std::int64_t seed_block = 4;         ///< one point to start from in each block of so many samples along each axis
  std::uint64_t most_memory_bytes = 0; ///< of the triangulation; 0: any
};

/// Where the interpolated volume has the value `iso`, in world coordinates, pointing out of what is bright, and closed
/// where it meets the border of the volume: all outside is dark. A part that is too small to have a few of the points
/// from which the mesher starts may be missed. Each edge has two triangles, unless the surface touches itself there.
/// Without the arrays of a mesh; empty where no two neighbours have the value between them. The same in every run.
///
/// One thread. Throws Cancelled, InputError where the triangulation outgrows its memory, and UsageError where this
/// program does not hold the mesher.
Mesh cgal_surface(const Volume &volume, double iso, const CgalMesherOptions &options = {},
                  const Progress &progress = {});

} // namespace volsurf
