#include "volsurf/pipeline/find_regions.h"

#include "volsurf/baseline/otsu.h"
#include "volsurf/baseline/threshold.h"
#include "volsurf/baseline/watershed.h"
#include "volsurf/core/error.h"
#include "volsurf/topology/label_merge.h"

#include <algorithm>
#include <sstream>

namespace volsurf {

namespace {

LabelVolume labels_of(const MergedVolume &merged, const Settings &settings, const Progress &progress)
{
  const Volume &volume = merged.input.volume;
  report_progress(progress, method_text(settings.method), 0);
  if (settings.method == Method::threshold)
    return threshold(volume, *settings.iso);
  const EdgeField field(volume, merged.field);
  return morphological_watershed(gradient_magnitude(field, volume.grid), std::get<DeltaValue>(settings.delta).per_mm,
                                 progress);
}

/// Two or more regions: the surface between them is not empty.
void require_two_regions(const MergedVolume &merged, const Settings &settings)
{
  if (merged.merge.hierarchy.basin_count() > 1)
    return;
  const auto &samples = merged.input.volume.samples;
  std::ostringstream message;
  message << settings.input.string() << ": --method " << method_text(settings.method) << " finds no surface: ";
  if (settings.method == Method::threshold) {
    const auto [lowest, highest] = std::minmax_element(samples.begin(), samples.end());
    message << "the samples are from " << *lowest << " to " << *highest << ", the iso-value is " << *settings.iso;
  } else {
    message << "all is one region at " << delta_text(settings.delta);
  }
  throw EmptyResult(message.str());
}

} // namespace

Settings settings_with_iso_value(Settings settings, const Volume &volume)
{
  if (takes_iso_value(settings.method) && !settings.iso)
    settings.iso = otsu_value(volume);
  return settings;
}

void find_regions(MergedVolume &merged, const Settings &settings, const Progress &progress)
{
  if (settings.method == Method::volsurf)
    return merge_input(merged, progress);
  merged.merge = merge_of_labels(labels_of(merged, settings, progress));
  merged.cells_are_voxels = true;
  require_two_regions(merged, settings);
}

} // namespace volsurf
