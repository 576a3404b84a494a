#include "volsurf/pipeline/isosurfaces.h"

#include "volsurf/baseline/cgal_mesher.h"
#include "volsurf/baseline/isosurface.h"
#include "volsurf/core/error.h"
#include "volsurf/pipeline/summary.h"
#include "volsurf/surface/mesh_components.h"

#include <algorithm>
#include <sstream>

namespace volsurf {

namespace {

Mesh surface_by_mesher(const Volume &volume, const Settings &settings, const Progress &progress)
{
  CgalMesherOptions options;
  options.most_memory_bytes = allowed_memory_bytes(settings);
  try {
    return cgal_surface(volume, *settings.iso, options, progress);
  } catch (const InputError &error) {
    throw InputError(settings.input.string() + ": --method cgal-mesher: " + error.what());
  }
}

Mesh surface_by_method(const Volume &volume, const Settings &settings, const Progress &progress)
{
  if (settings.method == Method::cgal_mesher)
    return surface_by_mesher(volume, settings, progress);
  return isosurface(volume, *settings.iso,
                    settings.method == Method::marching_cubes ? IsosurfaceFilter::marching_cubes
                                                              : IsosurfaceFilter::flying_edges);
}

void require_triangles(const Mesh &mesh, const Volume &volume, const Settings &settings)
{
  if (!mesh.triangles.empty())
    return;
  const auto [lowest, highest] = std::minmax_element(volume.samples.begin(), volume.samples.end());
  std::ostringstream message;
  message << settings.input.string() << ": --method " << method_text(settings.method)
          << " finds no surface: the samples are from " << *lowest << " to " << *highest << ", the iso-value is "
          << *settings.iso;
  throw EmptyResult(message.str());
}

} // namespace

void make_isosurface(const Volume &volume, const Settings &settings, const SurfaceSink &sink)
{
  report_progress(sink.progress, "surface", 0);
  Mesh mesh = surface_by_method(volume, settings, sink.progress);
  require_triangles(mesh, volume, settings);
  sink.timer.lap("surface");
  report_progress(sink.progress, "components", 0);
  const Components components = find_components(mesh, settings.components);
  add_components(components, sink.report);
  mesh = keep_components(mesh, components);
  sink.timer.lap("components");

  SurfaceWriter writer(Finisher(volume.grid, settings), settings, sink);
  writer.expect_components();
  writer.write(std::move(mesh));
  summarise_surfaces(sink.report);
}

} // namespace volsurf
