// From the staircase of faces to the surface: smoothing, then sub-voxel placement, of a finer mesh where slices are
// thick.
#pragma once

#include "volsurf/field/edge_locator.h"
#include "volsurf/pipeline/settings.h"
#include "volsurf/surface/snap.h"

namespace volsurf {

/// What finishing did to a mesh.
struct Finishing {
  SmoothingResult smoothing;
  std::optional<PlacementResult> snap; ///< not set: the points were not placed
};

/// Finishes meshes of one volume.
class Finisher {
public:
  /// Keeps references to `volume` and `settings`. Sub-voxel placement needs a smoothed mesh and a volume with
  /// intensities on the two sides of a wall, so `--smooth 0` and `--edge-map` leave it out, as `--snap off` does.
  Finisher(const Volume &volume, double sigma_mm, const Settings &settings);

  /// Smooths only. Keeps references to both; `grid` is that of the cells' corners.
  Finisher(const Grid &grid, const Settings &settings) : grid_(grid), settings_(settings) {}

  /// Throws as smooth_mesh(). Takes 15 bytes per sample of the box around the mesh where that encloses one thing;
  /// otherwise the volume is blurred for it, the first time, which takes 4 bytes per sample and is kept.
  Finishing finish(Mesh &mesh);

private:
  PlacementResult place(Mesh &mesh);

  const Grid &grid_;
  const Settings &settings_;
  const Volume *volume_ = nullptr; // not set: points are not placed
  double sigma_mm_ = 0;
  double noise_ = 0; // sd in a sample
  std::optional<EdgeLocator> locator_;
};

} // namespace volsurf
