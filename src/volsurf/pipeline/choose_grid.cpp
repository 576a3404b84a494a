#include "volsurf/pipeline/choose_grid.h"

#include "volsurf/field/facing_walls.h"
#include "volsurf/field/noise_level.h"
#include "volsurf/field/oversample.h"
#include "volsurf/pipeline/merged_volume.h"

namespace volsurf {

namespace {

/// The part of its walls that face another one, from which on a scan is folded.
constexpr double kFolded = 0.08;

constexpr int kFiner = 2;

} // namespace

bool leaves_oversampling_to_scan(const Settings &settings, const Grid &scan)
{
  const bool delta_is_given = !std::holds_alternative<AutomaticDelta>(settings.delta);
  if (settings.oversampling || delta_is_given || settings.field.sigma_mm || settings.hierarchy)
    return false;
  if (settings.method != Method::volsurf || settings.field.edge_map)
    return false;
  if (has_thick_slices(scan) || scan.sample_count() > kMostSamplesToOversample)
    return false;
  return expected_memory_bytes(oversampled_grid(scan, kFiner)) <= allowed_memory_bytes(settings);
}

int choose_oversampling(const Volume &scan)
{
  return part_of_facing_walls(scan, measure_sample_noise(scan)) > kFolded ? kFiner : 1;
}

} // namespace volsurf
