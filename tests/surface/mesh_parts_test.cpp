#include "volsurf/surface/mesh_parts.h"

#include "support/grids.h"
#include "support/label_volumes.h"

#include "volsurf/surface/check.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

using namespace volsurf;
using namespace volsurf::support;

namespace {

Mesh random_surface(Dice &dice)
{
  const LabelledCells labels = random_cells(dice, 6, 4);
  Grid grid = any_grid(dice);
  grid.size = grid_of(labels.cells.size).size;
  return mesh_of(labels, grid, all_sides(labels), false);
}

std::size_t component_count(const Mesh &mesh)
{
  return std::set<ComponentId>(mesh.component.begin(), mesh.component.end()).size();
}

std::array<Point, 3> corners(const Mesh &mesh, std::size_t triangle)
{
  const Triangle &t = mesh.triangles[triangle];
  return {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
}

} // namespace

RC_GTEST_PROP(MeshParts, HoldEachTriangleOnceAsItIsInTheWhole, ())
{
  Dice dice(*random_seed());
  const Mesh mesh = random_surface(dice);
  const std::size_t components = component_count(mesh);
  std::size_t triangles = 0;
  const auto lists = triangles_by_component(mesh, components);
  RC_ASSERT(lists.size() == components);
  for (ComponentId component = 1; component <= components; ++component) {
    const TriangleList &list = lists[component - 1];
    RC_ASSERT(std::is_sorted(list.begin(), list.end()));
    const Mesh part = take_triangles(mesh, list);
    RC_ASSERT(part.triangles.size() == list.size());
    triangles += list.size();
    std::set<PointId> used;
    for (std::size_t i = 0; i < list.size(); ++i) {
      RC_ASSERT(corners(part, i) == corners(mesh, list[i]));
      RC_ASSERT(part.component[i] == component);
      RC_ASSERT(part.region_a[i] == mesh.region_a[list[i]]);
      RC_ASSERT(part.region_b[i] == mesh.region_b[list[i]]);
      RC_ASSERT(part.persistence[i] == mesh.persistence[list[i]]);
      RC_ASSERT(part.cap[i] == mesh.cap[list[i]]);
      used.insert(part.triangles[i].begin(), part.triangles[i].end());
    }
    RC_ASSERT(used.size() == part.points.size());
  }
  RC_ASSERT(triangles == mesh.triangles.size());
}

RC_GTEST_PROP(MeshParts, VolumesAreThoseOfClosedParts, ())
{
  Dice dice(*random_seed());
  const Mesh mesh = random_surface(dice);
  const std::size_t components = component_count(mesh);
  const auto lists = triangles_by_component(mesh, components);
  const auto volumes = volumes_by_component_mm3(mesh, components);
  for (std::size_t i = 0; i < components; ++i) {
    const MeshCheck check = check_mesh(take_triangles(mesh, lists[i]));
    if (check.watertight)
      RC_ASSERT(std::abs(volumes[i] - check.volume_mm3) <= 1e-3 * check.area_mm2);
  }
}
