#include "volsurf/surface/smoothing.h"

#include "volsurf/core/error.h"
#include "volsurf/interop/vtk_mesh.h"
#include "volsurf/surface/cap_points.h"
#include "volsurf/surface/check.h"

#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace volsurf {

namespace {

[[noreturn]] void refuse(const char *option, double found, const char *allowed)
{
  std::ostringstream message;
  message << option << ": found " << found << "; allowed are " << allowed;
  throw UsageError(message.str());
}

void put_back_into_planes(const std::vector<CapPoint> &cap_points, const Grid &grid, Mesh &mesh)
{
  for (const CapPoint &cap : cap_points) {
    Point &point = mesh.points[cap.point];
    Vec3 index = world_to_index(grid, {point[0], point[1], point[2]});
    index[cap.axis] = cap.index;
    const Vec3 world = index_to_world(grid, index);
    point = {static_cast<float>(world[0]), static_cast<float>(world[1]), static_cast<float>(world[2])};
  }
}

/// Undoes the filter's gain at frequency zero, which is up to 1 % off 1: it scales all points about the middle of their
/// bounds, those that it holds fixed too. `lone` is a point of no triangle, which shows the gain.
void undo_gain(const std::array<double, 3> &middle, const std::array<double, 3> &lone,
               const std::array<double, 3> &lone_after, Mesh &mesh)
{
  const double before = std::hypot(lone[0] - middle[0], lone[1] - middle[1], lone[2] - middle[2]);
  const double after = std::hypot(lone_after[0] - middle[0], lone_after[1] - middle[1], lone_after[2] - middle[2]);
  for (Point &point : mesh.points)
    for (int i = 0; i < 3; ++i)
      point[i] = static_cast<float>(middle[i] + (point[i] - middle[i]) * before / after);
}

void run_filter(Mesh &mesh, const SmoothingResult &parameters)
{
  const auto data = to_poly_data(mesh);
  const double *const bounds = data->GetPoints()->GetBounds();
  const std::array<double, 3> lone{bounds[0], bounds[2], bounds[4]};
  const std::array<double, 3> middle{(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2,
                                     (bounds[4] + bounds[5]) / 2};
  const vtkIdType lone_id = data->GetPoints()->InsertNextPoint(lone.data());
  const auto filter = vtkSmartPointer<vtkWindowedSincPolyDataFilter>::New();
  filter->SetInputData(data);
  filter->SetNumberOfIterations(parameters.iterations);
  filter->SetPassBand(parameters.pass_band);
  filter->NormalizeCoordinatesOn();
  filter->FeatureEdgeSmoothingOff();
  filter->NonManifoldSmoothingOff(); // junctions are treated as curves
  filter->BoundarySmoothingOn();
  filter->SetEdgeAngle(180); // a staircase's corners are no corners of the curve
  filter->Update();

  vtkPoints &points = *filter->GetOutput()->GetPoints();
  std::array<double, 3> lone_after{};
  points.GetPoint(lone_id, lone_after.data());
  points.SetNumberOfPoints(lone_id);
  copy_points(*filter->GetOutput(), mesh);
  undo_gain(middle, lone, lone_after, mesh);
}

void require_finite(const Mesh &mesh)
{
  for (const Point &point : mesh.points)
    for (const float coordinate : point)
      if (!std::isfinite(coordinate))
        throw Error("smoothing overflowed; try --smooth 0 or a larger --passband");
}

} // namespace

int usual_iterations(double strength)
{
  return static_cast<int>(std::lround(20 + 20 * strength));
}

void check_smoothing(const SmoothingOptions &options)
{
  if (!(options.strength >= 0 && options.strength <= 1))
    refuse("--smooth", options.strength, "0 to 1");
  if (options.iterations && (*options.iterations < kFewestIterations || *options.iterations > 1000))
    refuse("--iterations", *options.iterations, "15 to 1000");
  if (options.pass_band && !(*options.pass_band >= kSmallestPassBand && *options.pass_band <= 2))
    refuse("--passband", *options.pass_band, "0.001 to 2");
}

SmoothingResult smooth_mesh(Mesh &mesh, const Grid &grid, const SmoothingOptions &options)
{
  check_smoothing(options);
  if (options.strength == 0 || mesh.points.empty())
    return {};
  SmoothingResult result;
  result.iterations = options.iterations.value_or(usual_iterations(options.strength));
  result.pass_band = options.pass_band.value_or(std::pow(10.0, -1 - 0.7 * options.strength));

  const double volume_before = signed_volume_mm3(mesh);
  const auto cap_points = find_cap_points(mesh, grid);
  run_filter(mesh, result);
  put_back_into_planes(cap_points, grid, mesh);
  require_finite(mesh);
  if (volume_before != 0)
    result.volume_drift = signed_volume_mm3(mesh) / volume_before - 1;
  return result;
}

} // namespace volsurf
