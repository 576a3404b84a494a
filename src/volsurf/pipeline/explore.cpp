#include "volsurf/pipeline/explore.h"

#include "volsurf/core/parallel.h"
#include "volsurf/topology/region_sizes.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

constexpr std::size_t kMostStrong = 10;
constexpr std::size_t kMostProminent = 15;

/// Of patches of the boundary and what joins them, beyond what a cut needs: the CT head takes 5.
constexpr std::uint64_t kCurveBytesPerSample = 6;

/// As for a given delta, since the answers are for all of them: a scan's grid may depend on --delta auto.
MergedVolume read_for_every_delta(Settings settings, const Progress &progress,
                                  const std::function<void(const Grid &)> &found)
{
  settings.delta = DeltaValue{};
  return read_input(settings, progress, [&](const Grid &grid) {
    if (found)
      found(grid);
    const auto samples = static_cast<std::uint64_t>(grid.sample_count());
    require_memory(settings, grid, expected_memory_bytes(grid) + kCurveBytesPerSample * samples);
  });
}

void require_walls(const Settings &settings, const Hierarchy &hierarchy)
{
  if (!(hierarchy.largest_persistence() > 0))
    throw EmptyResult(settings.input.string() + ": it is one region at every delta; no wall separates anything");
}

Vec3 cell_centre_mm(const CellLabels &cells, CellId cell, const Grid &grid, Frame frame)
{
  const Index3 &n = cells.size;
  const auto middle = [](std::int64_t position) { return static_cast<double>(position) + 0.5; };
  const Vec3 lps = index_to_world(grid, {middle(cell % n[0]), middle(cell / n[0] % n[1]), middle(cell / n[0] / n[1])});
  return frame == Frame::ras ? Vec3{-lps[0], -lps[1], lps[2]} : lps;
}

/// The background at delta is the region of the one survivor that its own basin comes to.
bool is_background_at(const Hierarchy &hierarchy, BasinId basin, double delta)
{
  BasinId survivor = hierarchy.background;
  while (hierarchy.persistence[survivor] < delta)
    survivor = hierarchy.ancestor[survivor];
  return survivor == basin;
}

/// The most prominent regions on offer so far; of equals the stronger one, which is offered first.
class MostProminent {
public:
  void offer(const NotableRegion &region)
  {
    if (!std::isfinite(region.persistence) || region.is_background)
      return;
    const auto place = std::find_if(regions_.begin(), regions_.end(), [&](const NotableRegion &other) {
      return region.prominence() > other.prominence();
    });
    regions_.insert(place, region);
    if (regions_.size() > kMostProminent)
      regions_.pop_back();
  }

  std::vector<NotableRegion> take() { return std::move(regions_); }

private:
  std::vector<NotableRegion> regions_;
};

void summarise_regions(const RegionMerge &merge, Exploration &exploration)
{
  const Hierarchy &hierarchy = merge.hierarchy;
  const std::vector<std::int64_t> sizes = largest_region_sizes(hierarchy);
  const double cell_mm3 = voxel_volume_mm3(exploration.grid);
  MostProminent prominent;
  for (const BasinId basin : hierarchy.by_rank) {
    const double volume_mm3 = cell_mm3 * static_cast<double>(sizes[basin]);
    exploration.volumes_mm3.push_back(volume_mm3);
    const double persistence = hierarchy.persistence[basin];
    if (hierarchy.roots[basin] < 0)
      continue; // the exterior has no place
    const Vec3 point =
        cell_centre_mm(merge.cells, hierarchy.roots[basin], exploration.grid, exploration.settings.frame);
    const NotableRegion region{persistence, volume_mm3, point, is_background_at(hierarchy, basin, persistence)};
    if (exploration.strongest.size() < kMostStrong && persistence > 0)
      exploration.strongest.push_back(region);
    if (persistence > exploration.advice.noise_floor)
      prominent.offer(region);
  }
  exploration.prominent = prominent.take();
}

} // namespace

double NotableRegion::prominence() const
{
  return persistence * std::cbrt(volume_mm3 * 3 / (4 * 3.14159265358979));
}

std::optional<double> Exploration::noise_floor() const
{
  return advice.noise_floor > 0 ? std::optional<double>(advice.noise_floor) : std::nullopt;
}

std::optional<double> Exploration::automatic_delta() const
{
  return advice.candidates.empty() ? std::nullopt : std::optional<double>(advice.candidates.front().delta);
}

BoundaryCurve boundary_curve(const RegionMerge &merge, const Grid &grid, const Progress &progress)
{
  const Hierarchy &hierarchy = merge.hierarchy;
  BasinRanks ranks;
  for (const BasinId basin : hierarchy.by_rank)
    ranks.persistence.push_back(hierarchy.persistence[basin]);
  ranks.background = hierarchy.background;
  ranks.joined_at = [&](BasinId a, BasinId b) { return joined_at_rank(hierarchy, a, b); };
  return find_boundary_curve(merge.cells, grid, ranks, progress);
}

Exploration explore(const Settings &settings, const Progress &progress, const std::function<void(const Grid &)> &found)
{
  const ThreadLimit limit(settings.threads);
  StageTimer timer;
  Exploration exploration;
  exploration.threads = settings.threads > 0 ? settings.threads : available_threads();

  MergedVolume merged = read_for_every_delta(settings, progress, found);
  exploration.settings = settings_of_merge(settings, merged);
  exploration.source = merged.input.source;
  exploration.pixel_type = merged.input.pixel_type;
  exploration.warnings = merged.input.warnings;
  exploration.grid = merged.input.volume.grid;
  timer.lap("read");

  merge_input(merged, progress);
  const EdgeField field(merged.input.volume, merged.field);
  exploration.sigma_mm = field.sigma_mm();
  exploration.non_finite_gradients = merged.non_finite_gradients;
  timer.lap("gradient and merge");
  require_walls(settings, merged.merge.hierarchy);
  exploration.advice = advise_on_delta(merged, field, settings.surface);
  timer.lap("delta");

  merged.input.volume.samples = {};
  exploration.curve = boundary_curve(merged.merge, exploration.grid, progress);
  summarise_regions(merged.merge, exploration);
  timer.lap("curve");
  exploration.seconds = timer.seconds();
  exploration.peak_memory_bytes = peak_memory_bytes();
  return exploration;
}

} // namespace volsurf
