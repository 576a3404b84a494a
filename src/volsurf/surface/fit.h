// Sub-voxel placement of a closed surface: moved until the scan that it would give is the scan that there is.
//
// Near a wall a scan is one intensity inside and another outside, and in voxels that the wall crosses a mixture by the
// parts on its sides. So a surface says what the scan around it should be, but for the two intensities, which least
// squares tell. What is left over at a point of the surface, with the sign of the contrast, says how far it lies too
// far in or out. Unlike an edge of the blurred scan this is right for walls closer than the blur is wide, where one
// hides the other, and for curved and creased ones, and noise enters in proportion, however strong: nothing is
// searched.
//
// In: a closed mesh around one thing, its staircase smoothed; the scan. Out: the mesh, its points moved. Guarantees:
// caps stay in the border planes of the grid, no triangle turns away from those around it, no thread count changes a
// byte. Passes, some rounds of: the parts of voxels inside (voxel_shares.h); at each point the two intensities, from
// the voxels around, and what is left over, from those next to it; all points are placed at once, as far as each is
// certain (fairing.h). In the end moves that would turn a triangle over are taken back.
//
// Source: after Lankton and Tannenbaum, "Localizing region-based active contours", IEEE Trans. Image Processing 17
// (2008), with voxels of mixed content as in Treece, Gee, Mayhew, Poole, "High resolution cortical bone thickness
// measurement from clinical CT data", Medical Image Analysis 14 (2010).
#pragma once

#include "volsurf/core/volume.h"
#include "volsurf/surface/placement.h"

namespace volsurf {

/// How far off a point counts as at least, in voxels of the scan. Without noise 0.03 leaves the study's shapes
/// 0.015 voxel off at most; more evens out the terraces of masks and labels.
constexpr double kLeastFitError = 0.03;

/// Whether a mesh is closed and no region is on the inside of one triangle and on the outside of another. O(triangles).
bool encloses_one_thing(const Mesh &mesh);

/// `mesh` must enclose one thing. No point moves further than kSnapLimitVoxels, on a finer grid so many times as far.
/// `volume` may be oversampled: only the samples of `scan`, its own grid, are looked at. `noise` is the standard
/// deviation in a sample, `least_error` how far off a point counts as at least, in voxels of the scan. O(rounds *
/// (points + samples near the mesh)); takes 15 bytes per sample of the box around the mesh.
PlacementResult fit_mesh(Mesh &mesh, const Volume &volume, const Grid &scan, double noise,
                         double least_error = kLeastFitError);

} // namespace volsurf
