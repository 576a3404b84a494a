#include "volsurf/pipeline/surface_writer.h"

#include "volsurf/pipeline/summary.h"
#include "volsurf/surface/mesh_parts.h"

#include <numeric>
#include <utility>

namespace volsurf {

SurfaceWriter::SurfaceWriter(Finisher finisher, const Settings &settings, const SurfaceSink &sink)
    : finisher_(std::move(finisher)), settings_(settings), sink_(sink)
{
}

void SurfaceWriter::expect_components() const
{
  if (settings_.split != Split::components)
    return;
  std::vector<ComponentId> numbers(static_cast<std::size_t>(sink_.report.components_kept));
  std::iota(numbers.begin(), numbers.end(), ComponentId{1});
  sink_.outputs.expect_parts(numbers);
}

void SurfaceWriter::write(Mesh mesh)
{
  if (settings_.split == Split::components)
    return write_components(std::move(mesh));
  const double volume_before_mm3 = signed_volume_mm3(mesh);
  smooth(mesh);
  write_part(0, 0, mesh, volume_before_mm3);
}

void SurfaceWriter::write_region(std::size_t part, RegionId number, Mesh mesh)
{
  const double volume_before_mm3 = signed_volume_mm3(mesh);
  smooth(mesh);
  write_part(part, number, mesh, volume_before_mm3);
}

void SurfaceWriter::write_components(Mesh mesh)
{
  const auto count = static_cast<std::size_t>(sink_.report.components_kept);
  const std::vector<double> volumes_before_mm3 = volumes_by_component_mm3(mesh, count);
  smooth(mesh);
  const std::vector<TriangleList> triangles = triangles_by_component(mesh, count);
  for (std::size_t part = 0; part < count; ++part)
    write_part(part, static_cast<ComponentId>(part + 1), take_triangles(mesh, triangles[part]),
               volumes_before_mm3[part]);
}

void SurfaceWriter::smooth(Mesh &mesh)
{
  report_progress(sink_.progress, "smooth", 0);
  add_finishing(finisher_.finish(mesh), sink_.report);
  sink_.timer.lap("smooth");
}

void SurfaceWriter::write_part(std::size_t part, std::uint32_t number, const Mesh &mesh, double volume_before_mm3) const
{
  const MeshCheck check = check_mesh(mesh);
  sink_.timer.lap("check");
  report_progress(sink_.progress, "write", 0);
  const auto files = sink_.outputs.write_surface(part, mesh, sink_.provenance);
  sink_.report.surfaces.push_back({number, files, check, volume_before_mm3});
  sink_.timer.lap("write");
}

} // namespace volsurf
