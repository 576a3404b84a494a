#include "volsurf/phantom/body_phantom.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"
#include "volsurf/phantom/bias_field.h"
#include "volsurf/phantom/shapes.h"

#include <algorithm>
#include <cmath>

namespace volsurf {

namespace {

double half_diagonal_mm(const Vec3 &spacing_mm)
{
  return 0.5 * length(spacing_mm);
}

Vec3 world_of(const Grid &grid, const Index3 &i)
{
  return index_to_world(grid, {static_cast<double>(i[0]), static_cast<double>(i[1]), static_cast<double>(i[2])});
}

/// The part of a small box that is inside, as if the surface were plane and the box faced it.
double part_inside(double distance, double width_mm)
{
  return std::clamp(0.5 - distance / width_mm, 0.0, 1.0);
}

/// The part of a voxel that is inside the body, by parts^3 boxes.
double coverage(const SignedDistance &distance, const Vec3 &centre, const Vec3 &spacing_mm, int parts)
{
  const double at_centre = distance(centre);
  // Twice, because distances may be true to first order only.
  if (std::abs(at_centre) > 2 * half_diagonal_mm(spacing_mm))
    return at_centre < 0 ? 1 : 0;
  const double width = std::cbrt(spacing_mm[0] * spacing_mm[1] * spacing_mm[2]) / parts;
  double sum = 0;
  for (int part = 0; part < parts * parts * parts; ++part) {
    const std::array<int, 3> place{part % parts, part / parts % parts, part / (parts * parts)};
    Vec3 point = centre;
    for (int axis = 0; axis < 3; ++axis)
      point[axis] += spacing_mm[axis] * ((place[axis] + 0.5) / parts - 0.5);
    sum += part_inside(distance(point), width);
  }
  return sum / (parts * parts * parts);
}

/// Calls row(index of the row's first sample, number of the row) for each row along x, in parallel.
template <typename Row>
void for_each_row(const Grid &grid, std::string_view stage, const Progress &progress, const Row &row)
{
  const std::int64_t rows = grid.size[1] * grid.size[2];
  constexpr std::int64_t kRowsPerSlab = 16;
  parallel_for_slabs(rows, kRowsPerSlab, [&](const Slab &slab) {
    report_progress(progress, stage, static_cast<double>(slab.begin) / static_cast<double>(rows));
    for (std::int64_t number = slab.begin; number < slab.end; ++number)
      row(Index3{0, number % grid.size[1], number / grid.size[1]}, number);
  });
}

double extent_of(BodyKind body, const Grid &grid)
{
  if (body == BodyKind::kCortex)
    return kHeadExtentMm;
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis)
    extent = std::max(extent, grid.spacing_mm[axis] * static_cast<double>(grid.size[axis]));
  return extent;
}

/// The distance at each sample of the grid itself.
std::vector<float> coarse_distances(const SignedDistance &distance, const Grid &grid, const Progress &progress)
{
  std::vector<float> values(static_cast<std::size_t>(grid.sample_count()));
  for_each_row(grid, "distance", progress, [&](Index3 index, std::int64_t row) {
    float *out = values.data() + row * grid.size[0];
    for (; index[0] < grid.size[0]; ++index[0])
      *out++ = static_cast<float>(distance(world_of(grid, index)));
  });
  return values;
}

/// Samples first .. last on each axis.
struct Box {
  Index3 first;
  Index3 last;
};

/// Around all samples inside, and two samples more, as far as the grid goes.
Box box_of_inside(const std::vector<float> &distances, const Grid &grid)
{
  Box box{grid.size, {-1, -1, -1}};
  for (std::int64_t i = 0; i < grid.sample_count(); ++i) {
    if (distances[static_cast<std::size_t>(i)] >= 0)
      continue;
    const Index3 index{i % grid.size[0], i / grid.size[0] % grid.size[1], i / (grid.size[0] * grid.size[1])};
    for (int axis = 0; axis < 3; ++axis) {
      box.first[axis] = std::min(box.first[axis], index[axis]);
      box.last[axis] = std::max(box.last[axis], index[axis]);
    }
  }
  if (box.last[0] < 0)
    throw UsageError("shape: no sample of the volume is inside; a larger --size shows it");
  for (int axis = 0; axis < 3; ++axis) {
    box.first[axis] = std::max<std::int64_t>(box.first[axis] - 2, 0);
    box.last[axis] = std::min(box.last[axis] + 2, grid.size[axis] - 1);
  }
  return box;
}

/// The grid over a box of samples, finer, and one sample more on each side, so that a surface can close there.
Grid fine_grid(const Grid &grid, const Box &box, int finer)
{
  Grid fine = grid;
  Vec3 first{};
  for (int axis = 0; axis < 3; ++axis) {
    fine.size[axis] = (box.last[axis] - box.first[axis]) * finer + 3;
    fine.spacing_mm[axis] = grid.spacing_mm[axis] / finer;
    first[axis] = static_cast<double>(box.first[axis]) - 1.0 / finer;
  }
  fine.origin_mm = index_to_world(grid, first);
  return fine;
}

/// The value for all of a coarse cell whose corners lie on one side, far from the surface; 0 for other cells.
float value_far_from_surface(const std::vector<float> &distances, const Grid &grid, const Index3 &cell)
{
  const double reach = 2 * length(grid.spacing_mm);
  float sum = 0;
  int inside = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const std::int64_t x = cell[0] + (corner & 1);
    const std::int64_t y = cell[1] + (corner >> 1 & 1);
    const std::int64_t z = cell[2] + (corner >> 2);
    const float value = distances[static_cast<std::size_t>((z * grid.size[1] + y) * grid.size[0] + x)];
    if (std::abs(value) < reach)
      return 0;
    inside += value < 0 ? 1 : 0;
    sum += value / 8;
  }
  return inside == 0 || inside == 8 ? sum : 0;
}

/// The cell of the grid that holds a fractional index, or the nearest one.
Index3 cell_at(const Grid &grid, const Vec3 &index)
{
  Index3 cell{};
  for (int axis = 0; axis < 3; ++axis)
    cell[axis] = std::clamp(static_cast<std::int64_t>(std::floor(index[axis])), std::int64_t{0}, grid.size[axis] - 2);
  return cell;
}

/// How far a place of the fine grid lies beyond the border of the coarse grid's samples: negative within.
double beyond_border(const Grid &grid, const Vec3 &index)
{
  double beyond = -1e9;
  for (int axis = 0; axis < 3; ++axis) {
    const double last = static_cast<double>(grid.size[axis] - 1);
    beyond = std::max(beyond, std::max(-index[axis], index[axis] - last) * grid.spacing_mm[axis]);
  }
  return beyond;
}

} // namespace

Phantom make_body_phantom(BodyKind body, const PhantomOptions &options, const Progress &progress)
{
  Phantom phantom;
  const Grid grid = phantom_grid(options);
  phantom.volume.grid = phantom.truth.grid = grid;
  phantom.volume.samples.resize(static_cast<std::size_t>(grid.sample_count()));
  if (options.with_truth)
    phantom.truth.labels.resize(phantom.volume.samples.size());
  const SignedDistance distance = body_distance(body, grid, options.anatomy, options.offset_mm);
  const BiasField bias = make_bias_field(grid, options.bias, options.anatomy, extent_of(body, grid));
  const int parts = body == BodyKind::kCortex ? 4 : 8; // the cortex costs most
  for_each_row(grid, "phantom", progress, [&](Index3 index, std::int64_t row) {
    auto sample = static_cast<std::size_t>(row * grid.size[0]);
    for (; index[0] < grid.size[0]; ++index[0], ++sample) {
      const Vec3 centre = world_of(grid, index);
      const double part = coverage(distance, centre, grid.spacing_mm, parts);
      const double signal = kBodySurroundings + part * (kBodySignal - kBodySurroundings);
      phantom.volume.samples[sample] = static_cast<float>(signal * bias_at(bias, index));
      if (options.with_truth)
        phantom.truth.labels[sample] = distance(centre) < 0 ? 1 : 0;
    }
  });
  return phantom;
}

int refinement_for(BodyKind body, const Grid &grid)
{
  if (body != BodyKind::kCortex)
    return 3;
  constexpr double kStepMm = 0.8; // the bottom of a sulcus has a radius of 1.2 mm
  return std::max(2, static_cast<int>(std::ceil(largest_spacing_mm(grid) / kStepMm)));
}

Volume sample_distance(const SignedDistance &distance, const Grid &grid, int finer, const Progress &progress)
{
  const std::vector<float> coarse = coarse_distances(distance, grid, progress);
  const Box box = box_of_inside(coarse, grid);
  Volume fine;
  fine.grid = fine_grid(grid, box, finer);
  fine.samples.resize(static_cast<std::size_t>(fine.grid.sample_count()));
  for_each_row(fine.grid, "distance", progress, [&](Index3 index, std::int64_t row) {
    float *out = fine.samples.data() + row * fine.grid.size[0];
    for (; index[0] < fine.grid.size[0]; ++index[0]) {
      Vec3 place{};
      for (int axis = 0; axis < 3; ++axis) // the first sample is the one beyond the box
        place[axis] = static_cast<double>(box.first[axis]) + static_cast<double>(index[axis] - 1) / finer;
      const float far = value_far_from_surface(coarse, grid, cell_at(grid, place));
      const double value = far != 0 ? far : distance(world_of(fine.grid, index));
      *out++ = static_cast<float>(std::max(value, beyond_border(grid, place)));
    }
  });
  return fine;
}

} // namespace volsurf
