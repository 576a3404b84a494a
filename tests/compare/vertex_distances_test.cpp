// The measures between clouds of points, by hand and beside VTK.
#include "support/solids.h"
#include "volsurf/compare/vertex_distances.h"
#include "volsurf/interop/vtk_mesh.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkHausdorffDistancePointSetFilter.h>
#include <vtkNew.h>

namespace volsurf::test {
namespace {

Mesh points(const std::vector<Point> &at)
{
  Mesh mesh;
  mesh.points = at;
  return mesh;
}

TEST(VertexDistances, AreThoseWorkedOutByHand)
{
  // From a to b: 1, 2. From b to a: 1, 2, 2, the last one to the first point of a. The centroid of b is
  // (10/3, 0, 1/3).
  const Mesh a = points({{0, 0, 1}, {10, 0, 0}});
  const Mesh b = points({{0, 0, 0}, {10, 2, 0}, {0, -2, 1}});
  const VertexDistances d = measure_vertex_distances(a, b);
  EXPECT_NEAR(d.mse_mm2, 0.5 * ((1.0 + 4) / 2 + (1.0 + 4 + 4) / 3), 1e-9);
  EXPECT_NEAR(d.mae_mm, 0.5 * ((1.0 + 2) / 2 + (1.0 + 2 + 2) / 3), 1e-9);
  EXPECT_NEAR(d.hausdorff_mm, 2, 1e-9);
  const double signal = ((100.0 / 9 + 0 + 1.0 / 9) + (400.0 / 9 + 4 + 1.0 / 9) + (100.0 / 9 + 4 + 4.0 / 9)) / 3;
  EXPECT_NEAR(d.snr_db, 10 * std::log10(signal / d.mse_mm2), 1e-6);
}

TEST(VertexDistances, OfPointsFromThemselvesAreZeroAndTheRatioIsInfinite)
{
  const Mesh a = sphere_mesh({0, 0, 0}, 10, 3);
  const VertexDistances d = measure_vertex_distances(a, a);
  EXPECT_EQ(d.mse_mm2, 0);
  EXPECT_EQ(d.mae_mm, 0);
  EXPECT_EQ(d.hausdorff_mm, 0);
  EXPECT_TRUE(std::isinf(d.snr_db) && d.snr_db > 0);
}

TEST(VertexDistances, RatioDoesNotDependOnThePlaceOrTheUnit)
{
  const Mesh a = sphere_mesh({0.5, 0, 0}, 10, 3);
  const Mesh b = sphere_mesh({0, 0, 0}, 10, 4);
  const double snr = measure_vertex_distances(a, b).snr_db;
  const auto move = [](const Mesh &mesh) { return moved(mesh, skew_rotation(), {500, -300, 100}, 3); };
  EXPECT_NEAR(measure_vertex_distances(move(a), move(b)).snr_db, snr, 1e-3);
}

TEST(VertexDistances, HausdorffIsThatOfVtk)
{
  const Mesh a = sphere_mesh({1, 2, 3}, 9, 3);
  const Mesh b = joined(sphere_mesh({0, 0, 0}, 10, 2), box_mesh({-12, 4, 4}, {3, 5, 6}));
  vtkNew<vtkHausdorffDistancePointSetFilter> filter;
  filter->SetInputData(0, to_poly_data(a));
  filter->SetInputData(1, to_poly_data(b));
  filter->SetTargetDistanceMethodToPointToPoint();
  filter->Update();
  EXPECT_NEAR(measure_vertex_distances(a, b).hausdorff_mm, filter->GetHausdorffDistance(), 1e-5);
}

} // namespace
} // namespace volsurf::test
