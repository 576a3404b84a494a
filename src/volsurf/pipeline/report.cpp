#include "volsurf/pipeline/report.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace volsurf {

namespace {

using Json = nlohmann::ordered_json;

/// JSON knows no infinity: null stands for it.
Json finite_or_null(double value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json geometry_json(const Grid &grid)
{
  return {{"size", grid.size},
          {"spacing_mm", grid.spacing_mm},
          {"origin_mm", grid.origin_mm},
          {"direction", grid.direction}};
}

Json path_or_null(const std::optional<std::filesystem::path> &path)
{
  return path ? Json(path->string()) : Json(nullptr);
}

Json options_json(const Report &report)
{
  const Settings &settings = report.settings;
  Json outputs = Json::array();
  for (const auto &output : settings.outputs)
    outputs.push_back(output.string());
  const bool is_volsurf = settings.method == Method::volsurf;
  const bool by_iso_value = takes_iso_value(settings.method);
  const std::string exterior = settings.exterior == Exterior::infinite ? "infinite" : "none";
  Json options{{"command_line", describe(settings, report.decision.delta)},
               {"method", method_text(settings.method)},
               {"delta", by_iso_value ? Json(nullptr) : Json(report.decision.delta)},
               {"iso", by_iso_value ? Json(settings.iso.value_or(0)) : Json(nullptr)},
               {"median_voxels", settings.median_voxels.value_or(0)},
               {"oversampling", report.grid.oversampling},
               {"sigma_mm", by_iso_value ? Json(nullptr) : Json(report.sigma_mm)},
               {"edge_map", settings.field.edge_map},
               {"exterior", is_volsurf ? Json(exterior) : Json(nullptr)},
               {"surface", settings.surface == SurfaceKind::hull ? "hull" : "all"},
               {"seeds_mm", settings.seeds_mm},
               {"region_numbers", settings.region_numbers},
               {"min_volume_mm3", settings.min_volume_mm3},
               {"keep", keep_text(settings.components.keep)},
               {"rank_by", rank_by_text(settings.components.rank_by)},
               {"smooth", settings.smoothing.strength},
               {"snap", is_volsurf && settings.snap},
               {"iterations", report.smoothing.iterations},
               {"passband", report.smoothing.pass_band},
               {"frame", frame_name(settings.frame)},
               {"outputs", outputs},
               {"split", split_text(settings.split)},
               {"labels", path_or_null(settings.labels)},
               {"report", path_or_null(settings.report)},
               {"save_hierarchy", path_or_null(settings.hierarchy)},
               {"series_uid", settings.series_uid.empty() ? Json(nullptr) : Json(settings.series_uid)},
               {"threads", report.threads}};
  return options;
}

Json delta_choice_json(const Report &report)
{
  if (report.settings.method != Method::volsurf)
    return nullptr;
  Json noise = nullptr;
  Json candidates = Json::array();
  if (const auto &advice = report.decision.advice) {
    noise = {{"standard_deviation", advice->noise.volume},
             {"in_gradient", advice->noise.gradient},
             {"floor", advice->noise_floor}};
    for (const DeltaCandidate &candidate : advice->candidates)
      candidates.push_back({{"delta", candidate.delta},
                            {"low", candidate.low},
                            {"high", candidate.high},
                            {"width", candidate.width},
                            {"regions", candidate.regions}});
  }
  return {{"given", delta_text(report.settings.delta)}, {"noise", noise}, {"candidates", candidates}};
}

Json regions_json(const Report &report)
{
  Json regions = Json::array();
  for (const RegionSummary &region : report.strongest_regions)
    regions.push_back({{"id", region.id},
                       {"persistence", finite_or_null(region.persistence)},
                       {"cells", region.cells},
                       {"maximum_mm", region.maximum_mm}});
  return regions;
}

Json surfaces_json(const Report &report)
{
  Json surfaces = Json::array();
  for (const SurfaceSummary &surface : report.surfaces) {
    const auto number_of = [&](Split split) {
      return report.settings.split == split ? Json(surface.number) : Json(nullptr);
    };
    Json files = Json::array();
    for (const auto &file : surface.files)
      files.push_back(file.string());
    const MeshCheck &mesh = surface.mesh;
    surfaces.push_back({{"region", number_of(Split::regions)},
                        {"component", number_of(Split::components)},
                        {"files", files},
                        {"triangles", mesh.triangles},
                        {"watertight", mesh.watertight},
                        {"volume_mm3", mesh.volume_mm3},
                        {"volume_drift", mesh.watertight ? Json(surface.volume_drift()) : Json(nullptr)}});
  }
  return surfaces;
}

Json snap_json(const Report &report)
{
  if (!report.snap)
    return nullptr;
  return {{"moved", report.snap->moved},
          {"followed", report.snap->followed},
          {"rejected", report.snap->rejected},
          {"root_mean_square_mm", report.snap->root_mean_square_mm}};
}

Json mesh_json(const Report &report)
{
  const MeshCheck &mesh = report.mesh;
  return {{"points", mesh.points},
          {"triangles", mesh.triangles},
          {"shells", mesh.shells},
          {"watertight", mesh.watertight},
          {"open_edges", mesh.open_edges},
          {"non_manifold_edges", mesh.non_manifold_edges},
          {"misoriented_edges", mesh.misoriented_edges},
          {"genus", mesh.watertight ? Json(mesh.genus) : Json(nullptr)},
          {"area_mm2", mesh.area_mm2},
          {"volume_mm3", mesh.volume_mm3},
          {"volume_drift", mesh.watertight ? Json(report.smoothing.volume_drift) : Json(nullptr)},
          {"bounds_low_mm", mesh.bounds_low_mm},
          {"bounds_high_mm", mesh.bounds_high_mm}};
}

} // namespace

std::string to_json(const Report &report)
{
  const bool is_volsurf = report.settings.method == Method::volsurf;
  const bool has_regions = finds_regions(report.settings.method);
  Json seconds = Json::object();
  for (const auto &[stage, duration] : report.seconds)
    seconds[stage] = duration;
  const Json json{{"version", version_text()},
                  {"source",
                   {{"path", report.source.path},
                    {"bytes", report.source.bytes},
                    {"sha256", report.source.sha256},
                    {"pixel_type", report.pixel_type},
                    {"hierarchy", report.is_stored_merge ? Json(report.settings.input.string()) : Json(nullptr)}}},
                  {"geometry", geometry_json(report.grid)},
                  {"options", options_json(report)},
                  {"counts",
                   {{"samples", report.grid.sample_count()},
                    {"cells", report.grid.cell_count()},
                    {"non_finite_gradients", report.non_finite_gradients},
                    {"basins", is_volsurf ? Json(report.basins) : Json(nullptr)},
                    {"regions", has_regions ? Json(report.regions) : Json(nullptr)},
                    {"boundary_faces", report.boundary_faces},
                    {"components", report.components},
                    {"components_kept", report.components_kept},
                    {"components_dropped", report.components - report.components_kept}}},
                  {"delta_choice", delta_choice_json(report)},
                  {"largest_persistence", is_volsurf ? Json(report.largest_persistence) : Json(nullptr)},
                  {"background_region", has_regions ? Json(report.background_region) : Json(nullptr)},
                  {"strongest_regions", regions_json(report)},
                  {"component_sizes", report.component_sizes},
                  {"surfaces", surfaces_json(report)},
                  {"mesh", mesh_json(report)},
                  {"snap", snap_json(report)},
                  {"warnings", report.warnings},
                  {"seconds", seconds},
                  {"peak_memory_bytes", report.peak_memory_bytes}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace volsurf
