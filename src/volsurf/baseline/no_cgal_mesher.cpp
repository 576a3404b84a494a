// What stands for the mesher in a program that is built without it.
#include "volsurf/baseline/cgal_mesher.h"

namespace volsurf {

bool has_cgal_mesher()
{
  return false;
}

Mesh cgal_surface(const Volume & /*volume*/, double /*iso*/, const CgalMesherOptions & /*options*/,
                  const Progress & /*progress*/)
{
  throw UsageError("this program is built without CGAL; build it with -DVOLSURF_WITH_CGAL=ON");
}

} // namespace volsurf
