#include "volsurf/pipeline/method.h"

#include "volsurf/baseline/cgal_mesher.h"
#include "volsurf/core/error.h"
#include "volsurf/pipeline/file_names.h"
#include "volsurf/pipeline/settings.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

class MethodChecker {
public:
  explicit MethodChecker(Method method) : method_(method) {}

  void refuse_if(bool given, const std::string &option) const
  {
    if (given)
      throw UsageError("--method " + method_text(method_) + ": found " + option + ", which means nothing to it");
  }

private:
  Method method_;
};

void require_built(Method method)
{
  if (method == Method::cgal_mesher && !has_cgal_mesher())
    throw UsageError("--method cgal-mesher: found a program built without CGAL; to get it, install libcgal-dev and "
                     "build with -DVOLSURF_WITH_CGAL=ON");
}

void check_watershed_level(const Settings &settings)
{
  if (!std::holds_alternative<DeltaValue>(settings.delta))
    throw UsageError("--method watershed: found " + delta_text(settings.delta) +
                     "; allowed is --delta with a number, in intensity per mm: no hierarchy tells more");
}

void check_iso_value(const Settings &settings)
{
  if (settings.iso && !std::isfinite(*settings.iso))
    throw UsageError("--iso: found " + std::to_string(*settings.iso) + "; allowed are otsu and finite numbers");
}

/// A mesh that is not made of faces between regions has none of them.
void refuse_regions(const Settings &settings, const MethodChecker &checker)
{
  checker.refuse_if(!settings.seeds_mm.empty(), "--seed");
  checker.refuse_if(!settings.region_numbers.empty(), "--region");
  checker.refuse_if(settings.min_volume_mm3 > 0, "--min-volume");
  checker.refuse_if(settings.split == Split::regions, "--split regions");
  checker.refuse_if(settings.labels.has_value(), "--labels");
  checker.refuse_if(std::any_of(settings.outputs.begin(), settings.outputs.end(), is_vdb), "a .vdb as output");
}

} // namespace

std::string method_text(Method method)
{
  switch (method) {
  case Method::threshold:
    return "threshold";
  case Method::isosurface:
    return "isosurface";
  case Method::marching_cubes:
    return "marching-cubes";
  case Method::cgal_mesher:
    return "cgal-mesher";
  case Method::watershed:
    return "watershed";
  case Method::volsurf:
    break;
  }
  return "volsurf";
}

bool takes_iso_value(Method method)
{
  return method == Method::threshold || !finds_regions(method);
}

bool finds_regions(Method method)
{
  return method != Method::isosurface && method != Method::marching_cubes && method != Method::cgal_mesher;
}

void check_method(const Settings &settings)
{
  const Method method = settings.method;
  const MethodChecker checker(method);
  require_built(method);
  check_iso_value(settings);
  if (takes_iso_value(method)) {
    checker.refuse_if(!std::holds_alternative<AutomaticDelta>(settings.delta), delta_text(settings.delta));
    checker.refuse_if(settings.field.sigma_mm.has_value(), "--sigma");
    checker.refuse_if(settings.field.edge_map, "--edge-map");
  } else {
    checker.refuse_if(settings.iso.has_value(), "--iso");
  }
  if (method == Method::volsurf)
    return;
  checker.refuse_if(settings.exterior.has_value(), "--exterior");
  checker.refuse_if(settings.hierarchy.has_value(), "--save-hierarchy");
  if (method == Method::watershed)
    check_watershed_level(settings);
  if (!finds_regions(method))
    refuse_regions(settings, checker);
}

} // namespace volsurf
