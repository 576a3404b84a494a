#include "volsurf/interop/vtk_mesh.h"

#include "volsurf/core/error.h"

#include <cassert>
#include <cstring>
#include <utility>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedIntArray.h>

namespace volsurf {

namespace {

vtkSmartPointer<vtkPoints> to_points(const std::vector<Point> &points, Frame frame)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  float *out = coordinates->GetPointer(0);
  for (const Point &point : points)
    for (const float coordinate : to_frame(point, frame))
      *out++ = coordinate;
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetData(coordinates);
  return result;
}

template <typename Array> vtkSmartPointer<vtkCellArray> to_cells(const std::vector<Triangle> &triangles)
{
  using Id = typename Array::ValueType;
  vtkNew<Array> offsets;
  vtkNew<Array> corners;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(triangles.size()) + 1);
  corners->SetNumberOfValues(3 * static_cast<vtkIdType>(triangles.size()));
  Id *offset = offsets->GetPointer(0);
  Id *corner = corners->GetPointer(0);
  *offset = 0;
  for (const Triangle &triangle : triangles) {
    offset[1] = offset[0] + 3;
    ++offset;
    for (const PointId id : triangle)
      *corner++ = static_cast<Id>(id);
  }
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->SetData(offsets, corners);
  return result;
}

template <typename Array, typename Value>
void add_cell_array(vtkPolyData &data, const char *name, const std::vector<Value> &values)
{
  if (values.empty())
    return;
  static_assert(sizeof(Value) == sizeof(typename Array::ValueType));
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::memcpy(array->GetPointer(0), values.data(), values.size() * sizeof(Value));
  data.GetCellData()->AddArray(array);
}

template <typename Value> std::vector<Value> read_cell_array(vtkPolyData &data, const char *name)
{
  vtkDataArray *array = data.GetCellData()->GetArray(name);
  if (array == nullptr || array->GetNumberOfComponents() != 1)
    return {};
  std::vector<Value> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<Value>(array->GetTuple1(static_cast<vtkIdType>(i)));
  return values;
}

std::vector<Triangle> read_triangles(vtkPolyData &data)
{
  std::vector<Triangle> triangles;
  vtkCellArray *cells = data.GetPolys();
  triangles.reserve(static_cast<std::size_t>(cells->GetNumberOfCells()));
  vtkIdType count = 0;
  const vtkIdType *ids = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(count, ids) != 0;) {
    if (count != 3)
      throw InputError("found a polygon of " + std::to_string(count) + " corners; allowed: triangles");
    triangles.push_back({static_cast<PointId>(ids[0]), static_cast<PointId>(ids[1]), static_cast<PointId>(ids[2])});
  }
  return triangles;
}

} // namespace

vtkSmartPointer<vtkPolyData> to_poly_data(const Mesh &mesh, Frame frame)
{
  const std::size_t largest_id = std::max(mesh.points.size(), 3 * mesh.triangles.size());
  const bool fits_32_bits = largest_id <= static_cast<std::size_t>(VTK_TYPE_INT32_MAX);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(to_points(mesh.points, frame));
  data->SetPolys(fits_32_bits ? to_cells<vtkTypeInt32Array>(mesh.triangles)
                              : to_cells<vtkTypeInt64Array>(mesh.triangles));
  return data;
}

void add_cell_arrays(const Mesh &mesh, vtkPolyData &data)
{
  add_cell_array<vtkUnsignedIntArray>(data, "RegionA", mesh.region_a);
  add_cell_array<vtkUnsignedIntArray>(data, "RegionB", mesh.region_b);
  add_cell_array<vtkFloatArray>(data, "Persistence", mesh.persistence);
  add_cell_array<vtkUnsignedIntArray>(data, "Component", mesh.component);
  add_cell_array<vtkUnsignedCharArray>(data, "Cap", mesh.cap);
}

void copy_points(vtkPolyData &data, Mesh &mesh)
{
  assert(static_cast<std::size_t>(data.GetNumberOfPoints()) == mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    double position[3];
    data.GetPoint(static_cast<vtkIdType>(i), position);
    for (int axis = 0; axis < 3; ++axis)
      mesh.points[i][axis] = static_cast<float>(position[axis]);
  }
}

Mesh from_poly_data(vtkPolyData &data)
{
  Mesh mesh;
  mesh.points.resize(static_cast<std::size_t>(data.GetNumberOfPoints()));
  copy_points(data, mesh);
  mesh.triangles = read_triangles(data);
  mesh.region_a = read_cell_array<RegionId>(data, "RegionA");
  mesh.region_b = read_cell_array<RegionId>(data, "RegionB");
  mesh.persistence = read_cell_array<float>(data, "Persistence");
  mesh.component = read_cell_array<ComponentId>(data, "Component");
  mesh.cap = read_cell_array<std::uint8_t>(data, "Cap");
  return mesh;
}

Mesh from_index_space(vtkPolyData &data, const Grid &grid)
{
  Mesh mesh = from_poly_data(data);
  for (Point &point : mesh.points) {
    const Vec3 world = index_to_world(grid, {point[0], point[1], point[2]});
    point = {static_cast<float>(world[0]), static_cast<float>(world[1]), static_cast<float>(world[2])};
  }
  if (is_mirrored(grid))
    for (Triangle &triangle : mesh.triangles)
      std::swap(triangle[1], triangle[2]);
  return mesh;
}

} // namespace volsurf
