#include "volsurf/baseline/threshold.h"

#include "support/fields.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

RC_GTEST_PROP(Threshold, TakesTheSamplesThatAreAtLeastTheIsoValue, ())
{
  const Field field = *random_field();
  Volume volume;
  volume.grid.size = field.size;
  volume.grid.origin_mm = {1, 2, 3};
  volume.samples = field.values;
  const double iso = *rc::gen::elementOf(field.values);
  const LabelVolume labels = threshold(volume, iso);
  RC_ASSERT(labels.grid.size == volume.grid.size);
  RC_ASSERT(labels.grid.origin_mm == volume.grid.origin_mm);
  for (std::size_t i = 0; i < field.values.size(); ++i)
    RC_ASSERT(labels.labels[i] == (field.values[i] < iso ? 0U : 1U));
}
