// A threshold's regions and faces, against a plain count.
#include "volsurf/pipeline/find_regions.h"

#include "support/fields.h"

#include "volsurf/core/error.h"
#include "volsurf/surface/boundary.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

Settings threshold_at(double iso)
{
  Settings settings;
  settings.method = Method::threshold;
  settings.iso = iso;
  return settings;
}

MergedVolume volume_of(const Field &field)
{
  MergedVolume merged;
  merged.input.volume.grid.size = field.size;
  merged.input.volume.samples = field.values;
  return merged;
}

/// Faces between a voxel that is at least `iso` and one that is not, or the outside.
std::size_t count_faces(const Field &field, float iso)
{
  std::size_t faces = 0;
  for_each_sample(field.size, [&](const Index3 &p, SampleId sample) {
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        Index3 q = p;
        q[axis] += step;
        const bool is_outside = q[axis] < 0 || q[axis] >= field.size[axis];
        faces += field.values[sample] >= iso && (is_outside || field.values[sample_at(field, q)] < iso);
      }
  });
  return faces;
}

} // namespace

RC_GTEST_PROP(FindRegions, ByAThresholdHaveAllFacesBetweenInsideAndOutside, ())
{
  const Field field = *random_field();
  const float iso = *rc::gen::elementOf(field.values);
  RC_PRE(iso > *std::min_element(field.values.begin(), field.values.end()));
  MergedVolume merged = volume_of(field);
  find_regions(merged, threshold_at(iso));
  const Regions regions = cut(merged.merge.hierarchy, 1);
  RC_ASSERT(regions.count() == 2U);
  RC_ASSERT(corner_grid(merged).cell_size() == field.size);
  const RegionId background = regions.of_basin[merged.merge.hierarchy.background];
  RC_ASSERT(find_boundary(merged.merge.cells, {regions.of_basin, background}).size() == count_faces(field, iso));
}

TEST(FindRegions, ByAThresholdThatAllOrNoneReachAreRefused)
{
  Field field{{2, 2, 2}, {1, 2, 3, 4, 5, 6, 7, 8}};
  for (const double iso : {1.0, 8.5}) {
    MergedVolume merged = volume_of(field);
    EXPECT_THROW(find_regions(merged, threshold_at(iso)), EmptyResult) << iso;
  }
}
