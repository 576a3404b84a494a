#include "volsurf/interop/vtk_mesh.h"

#include "io/meshes.h"
#include "volsurf/core/error.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>

namespace volsurf {
namespace {

using test::small_mesh;

TEST(VtkMesh, GoesThereAndBackUnchanged)
{
  const Mesh mesh = small_mesh();
  const auto data = to_poly_data(mesh);
  add_cell_arrays(mesh, *data);
  const Mesh back = from_poly_data(*data);
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.triangles, mesh.triangles);
  EXPECT_EQ(back.region_a, mesh.region_a);
  EXPECT_EQ(back.region_b, mesh.region_b);
  EXPECT_EQ(back.persistence, mesh.persistence);
  EXPECT_EQ(back.component, mesh.component);
  EXPECT_EQ(back.cap, mesh.cap);
}

TEST(VtkMesh, KeepsPointsThatCoincideOrAreUnused)
{
  EXPECT_EQ(to_poly_data(small_mesh())->GetNumberOfPoints(), 5);
}

TEST(VtkMesh, LeavesOutEmptyArrays)
{
  Mesh mesh = small_mesh();
  mesh.cap.clear();
  const auto data = to_poly_data(mesh);
  add_cell_arrays(mesh, *data);
  EXPECT_EQ(data->GetCellData()->GetArray("Cap"), nullptr);
  EXPECT_TRUE(from_poly_data(*data).cap.empty());
}

TEST(VtkMesh, EmptyStaysEmpty)
{
  const Mesh back = from_poly_data(*to_poly_data(Mesh{}));
  EXPECT_TRUE(back.points.empty());
  EXPECT_TRUE(back.triangles.empty());
}

TEST(VtkMesh, CopiesMovedPointsBack)
{
  Mesh mesh = small_mesh();
  const auto data = to_poly_data(mesh);
  data->GetPoints()->SetPoint(3, 5, 6, 7);
  copy_points(*data, mesh);
  EXPECT_EQ(mesh.points[3], (Point{5, 6, 7}));
  EXPECT_EQ(mesh.points[4], small_mesh().points[4]);
}

TEST(VtkMesh, RefusesPolygonsThatAreNotTriangles)
{
  const auto data = to_poly_data(small_mesh());
  const vtkIdType square[] = {0, 1, 2, 3};
  data->GetPolys()->InsertNextCell(4, square);
  EXPECT_THROW(from_poly_data(*data), InputError);
}

} // namespace
} // namespace volsurf
