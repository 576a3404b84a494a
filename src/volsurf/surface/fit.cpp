#include "volsurf/surface/fit.h"

#include "volsurf/surface/check.h"
#include "volsurf/surface/fairing.h"
#include "volsurf/surface/mismatch.h"
#include "volsurf/surface/point_loop.h"
#include "volsurf/surface/scan_model.h"
#include "volsurf/surface/wall_contrast.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace volsurf {

namespace {

constexpr int kRounds = 8;

/// So many rounds take the scan at its word, noise aside, so that closed furrows open; in those that follow points
/// count less where the surface does not explain it even then: at the tips of thin bones and on the terraces of labels.
/// With none of these tips become ragged; with none of the first ones the study's cortex is up to twice as far off.
constexpr int kTrustingRounds = 3;

/// After so many rounds a wall is nearly where it should be, and a sample that is far off what the surface says is an
/// impulse: it counts as off by at most so many sds of the noise, or so much of the contrast if that is more. A wall
/// still on its way is held up by it, impulses pull as long as they are not: with 3 rounds the study's folds are up to
/// 6 % further off, with 8 of them shapes with impulses by up to a half.
constexpr int kUnlimitedRounds = 5;
constexpr double kLimitOfNoise = 2;
constexpr double kLimitOfStep = 0.25;

constexpr double kStep = 1.2; ///< of the way to where the mismatch is 0, to get there in fewer rounds

constexpr int kMargin = 6; ///< voxels around the mesh that are looked at

Window window_around(const PlacementMesh &placement, const Grid &scan)
{
  Vec3 low{scan.spacing_mm[0] * static_cast<double>(scan.size[0]),
           scan.spacing_mm[1] * static_cast<double>(scan.size[1]),
           scan.spacing_mm[2] * static_cast<double>(scan.size[2])};
  Vec3 high{0, 0, 0};
  for (const Vec3 &p : placement.positions)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  Window window{{}, scan, scan.size};
  for (int axis = 0; axis < 3; ++axis) {
    const auto first = static_cast<std::int64_t>(low[axis] / scan.spacing_mm[axis]) - kMargin;
    const auto last = static_cast<std::int64_t>(high[axis] / scan.spacing_mm[axis]) + 1 + kMargin;
    window.begin[axis] = std::clamp<std::int64_t>(first, 0, scan.size[axis] - 1);
    window.grid.size[axis] = std::clamp<std::int64_t>(last, 0, scan.size[axis] - 1) - window.begin[axis] + 1;
  }
  const auto &[x, y, z] = window.begin;
  window.grid.origin_mm =
      index_to_world(scan, {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  return window;
}

/// Layered where the merge found several regions.
Inside inside_of(const Mesh &mesh)
{
  const std::vector<RegionId> &regions = mesh.region_a;
  const bool has_several =
      std::any_of(regions.begin(), regions.end(), [&](RegionId region) { return region != regions.front(); });
  return has_several ? Inside::layered : Inside::uniform;
}

/// The mesh on its way. Places are in units of the grid's smallest spacing.
class Fit {
public:
  Fit(const PlacementMesh &placement, const Volume &volume, const Grid &scan, double noise, double least_error)
      : placement_(placement), unit_mm_(smallest_spacing_mm(placement.grid)), least_error_(least_error), noise_(noise),
        moving_(placement.mesh), model_(window_around(placement, scan), volume, inside_of(placement.mesh)),
        known_(placement.positions.size())
  {
  }

  std::vector<Target> targets_at(const std::vector<Vec3> &places)
  {
    for_each_point(places.size(), [&](std::size_t i) {
      moving_.points[i] = point_of_position(scaled(unit_mm_, places[i]), placement_.grid);
    });
    model_.set_surface(moving_);
    if (!around_ || looks_at_contrasts())
      around_.emplace(model_);
    std::vector<Target> targets(places.size());
    for_each_point(places.size(), [&](std::size_t i) { targets[i] = target_at(i, places); });
    ++round_;
    return targets;
  }

  /// 1 for the points that had a target of their own the last time.
  const std::vector<char> &known() const { return known_; }

private:
  /// They change little from round to round.
  bool looks_at_contrasts() const { return round_ < 2 || round_ % 2 == 1; }

  /// The sd of samples is the noise, until the surface has had the rounds to get there.
  Doubt doubt_about(const Contrast &contrast) const
  {
    Doubt doubt{round_ < kTrustingRounds ? noise_ : std::max(noise_, contrast.left_over)};
    if (round_ >= kUnlimitedRounds)
      doubt.limit = std::max(kLimitOfNoise * noise_, kLimitOfStep * std::abs(contrast.step));
    return doubt;
  }

  Target target_at(std::size_t i, const std::vector<Vec3> &places)
  {
    const int oversampling = placement_.grid.oversampling;
    Target target{places[i], oversampling * kErrorWithoutEdge, placement_.free_axes[i], placement_.on_feature[i] != 0};
    known_[i] = 0;
    const auto normal = placement_.wall_normal(static_cast<PointId>(i), places);
    if (!normal)
      return target;
    Vec3 index = index_of_position(scaled(unit_mm_, places[i]), model_.window.grid);
    for (int axis = 0; axis < 3; ++axis)
      index[axis] -= static_cast<double>(model_.window.begin[axis]);
    const auto contrast = around_->at(index);
    const auto mismatch = contrast ? mismatch_at(index, *contrast, doubt_about(*contrast), model_) : std::nullopt;
    if (!mismatch)
      return target;
    known_[i] = 1;
    const double voxel = voxel_mm(placement_.grid, *normal) / unit_mm_;
    const double outwards = is_mirrored(placement_.grid) ? -1 : 1; // triangles are wound as the world sees them
    target.position = plus(places[i], outwards * kStep * voxel * mismatch->way, *normal);
    const double error = std::hypot(oversampling * least_error_, voxel * mismatch->error);
    target.error = std::sqrt(kStep) * error; // longer steps pull harder
    return target;
  }

  const PlacementMesh &placement_;
  double unit_mm_;
  double least_error_;
  double noise_;
  Mesh moving_;
  ScanModel model_;
  std::vector<char> known_;
  std::optional<WallContrasts> around_;
  int round_ = 0;
};

} // namespace

bool encloses_one_thing(const Mesh &mesh)
{
  if (!check_mesh(mesh).watertight)
    return false;
  const std::unordered_set<RegionId> inside(mesh.region_a.begin(), mesh.region_a.end());
  return std::none_of(mesh.region_b.begin(), mesh.region_b.end(),
                      [&](RegionId region) { return inside.count(region) > 0; });
}

PlacementResult fit_mesh(Mesh &mesh, const Volume &volume, const Grid &scan, double noise, double least_error)
{
  const PlacementMesh placement(mesh, volume.grid);
  Fit fit(placement, volume, scan, noise, least_error);
  const auto find_targets = [&](const std::vector<Vec3> &places) { return fit.targets_at(places); };
  const int oversampling = volume.grid.oversampling;
  const auto places =
      fair_positions(placement.neighbours, find_targets, kRounds, places_of(placement), sampling_of(volume.grid));
  return move_points(placement, moves_to(places, oversampling * kSnapLimitVoxels, placement), fit.known(),
                     TurningOver::from_those_around, mesh);
}

} // namespace volsurf
