#include "volsurf/compare/mask.h"

#include "volsurf/interop/vtk_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

namespace volsurf {

namespace {

bool is_one_of(float sample, const std::vector<float> &labels)
{
  return labels.empty() ? sample > 0 : std::find(labels.begin(), labels.end(), sample) != labels.end();
}

/// Calls visit(index, linear index) for each sample of a grid of this size.
template <typename Visit> void for_each_sample(const Index3 &size, Visit visit)
{
  std::size_t linear = 0;
  for (std::int64_t z = 0; z < size[2]; ++z)
    for (std::int64_t y = 0; y < size[1]; ++y)
      for (std::int64_t x = 0; x < size[0]; ++x)
        visit(Index3{x, y, z}, linear++);
}

Grid grid_of_box(const Grid &grid, const GridBox &box)
{
  Grid part = grid;
  part.size = box.size;
  part.origin_mm = index_to_world(
      grid, {static_cast<double>(box.low[0]), static_cast<double>(box.low[1]), static_cast<double>(box.low[2])});
  return part;
}

/// The box of the samples inside, and one more on each side.
GridBox box_of_inside(const Mask &mask)
{
  Index3 low = mask.grid.size;
  Index3 high{-1, -1, -1};
  for_each_sample(mask.grid.size, [&](const Index3 &index, std::size_t linear) {
    if (mask.inside[linear] != 0)
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], index[axis]);
        high[axis] = std::max(high[axis], index[axis]);
      }
  });
  return {{low[0] - 1, low[1] - 1, low[2] - 1}, {high[0] - low[0] + 3, high[1] - low[1] + 3, high[2] - low[2] + 3}};
}

vtkSmartPointer<vtkImageData> to_image(const Mask &mask)
{
  vtkNew<vtkUnsignedCharArray> values;
  values->SetNumberOfValues(static_cast<vtkIdType>(mask.inside.size()));
  std::copy(mask.inside.begin(), mask.inside.end(), values->GetPointer(0));
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(mask.grid.size[0]), static_cast<int>(mask.grid.size[1]),
                       static_cast<int>(mask.grid.size[2]));
  image->GetPointData()->SetScalars(values);
  return image;
}

} // namespace

Mask mask_of_labels(const Volume &volume, const std::vector<float> &labels)
{
  Mask mask{volume.grid, std::vector<std::uint8_t>(volume.samples.size())};
  std::transform(volume.samples.begin(), volume.samples.end(), mask.inside.begin(),
                 [&](float sample) { return static_cast<std::uint8_t>(is_one_of(sample, labels)); });
  if (count_inside(mask) == 0)
    return {};
  return on_box(mask, box_of_inside(mask));
}

std::int64_t count_inside(const Mask &mask)
{
  return std::accumulate(mask.inside.begin(), mask.inside.end(), std::int64_t{0});
}

Mask on_box(const Mask &mask, const GridBox &box)
{
  Mask part{grid_of_box(mask.grid, box), {}};
  part.inside.resize(static_cast<std::size_t>(part.grid.sample_count()));
  const Index3 &size = mask.grid.size;
  for_each_sample(box.size, [&](const Index3 &index, std::size_t linear) {
    const Index3 from{index[0] + box.low[0], index[1] + box.low[1], index[2] + box.low[2]};
    const bool exists =
        from[0] >= 0 && from[1] >= 0 && from[2] >= 0 && from[0] < size[0] && from[1] < size[1] && from[2] < size[2];
    part.inside[linear] =
        exists ? mask.inside[static_cast<std::size_t>(from[0] + size[0] * (from[1] + size[1] * from[2]))] : 0;
  });
  return part;
}

std::optional<Index3> common_lattice(const Grid &a, const Grid &b)
{
  constexpr double kTolerance = 1e-3;
  Index3 offset{};
  for (int corner = 0; corner < 8; ++corner) {
    Index3 index{};
    for (int axis = 0; axis < 3; ++axis)
      index[axis] = (corner >> axis & 1) != 0 ? b.size[axis] - 1 : 0;
    const Vec3 place = world_to_index(a, index_to_world(b, {double(index[0]), double(index[1]), double(index[2])}));
    for (int axis = 0; axis < 3; ++axis) {
      if (corner == 0)
        offset[axis] = std::llround(place[axis]);
      if (std::abs(place[axis] - static_cast<double>(offset[axis] + index[axis])) > kTolerance)
        return std::nullopt;
    }
  }
  return offset;
}

Mesh mask_surface(const Mask &mask)
{
  vtkNew<vtkFlyingEdges3D> filter;
  filter->SetInputData(to_image(mask));
  filter->SetValue(0, 0.5);
  filter->ComputeNormalsOff();
  filter->ComputeScalarsOff();
  filter->Update();
  return from_index_space(*filter->GetOutput(), mask.grid);
}

} // namespace volsurf
