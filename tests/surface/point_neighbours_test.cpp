#include "volsurf/surface/point_neighbours.h"

#include "support/label_volumes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

using namespace volsurf;
using namespace volsurf::support;

RC_GTEST_PROP(PointNeighbours, AreThePointsOfAllEdgesOnce, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = random_cells(dice, 4, 3);
  const Mesh mesh = mesh_of(labels, grid_of(labels.cells.size), all_sides(labels), false);
  std::vector<std::set<PointId>> expected(mesh.points.size());
  for (const Triangle &triangle : mesh.triangles)
    for (const PointId a : triangle)
      for (const PointId b : triangle)
        if (a != b)
          expected[a].insert(b);

  const PointNeighbours neighbours(mesh);
  RC_ASSERT(neighbours.size() == mesh.points.size());
  for (std::size_t point = 0; point < mesh.points.size(); ++point) {
    std::vector<PointId> found;
    neighbours.for_each(point, [&](PointId other) { found.push_back(other); });
    RC_ASSERT(found == std::vector<PointId>(expected[point].begin(), expected[point].end()));
    RC_ASSERT(neighbours.count(point) == expected[point].size());
  }
}
