#include "volsurf/pipeline/stored_facts.h"

#include "volsurf/core/error.h"
#include "volsurf/field/median.h"
#include "volsurf/field/oversample.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace volsurf {

namespace {

using Json = nlohmann::ordered_json;

struct BadFact {
  std::string what;
};

void require(bool holds, const std::string &what)
{
  if (!holds)
    throw BadFact{what};
}

template <typename Value> Json value_or_null(const std::optional<Value> &value)
{
  return value ? Json(*value) : Json(nullptr);
}

std::int64_t integer_at(const Json &object, const std::string &key, std::int64_t least)
{
  const Json &value = object.at(key);
  require(value.is_number_integer() && value.get<std::int64_t>() >= least, key);
  return value.get<std::int64_t>();
}

Index3 size_of(const Json &size)
{
  constexpr std::int64_t kMostSamples = std::int64_t{1} << 48;
  require(size.size() == 3, "size");
  Index3 result{};
  std::int64_t samples = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    require(size[axis].is_number_integer(), "size");
    result[axis] = size[axis].get<std::int64_t>();
    require(result[axis] >= 2 && result[axis] <= kMostSamples / samples, "size");
    samples *= result[axis];
  }
  return result;
}

Grid grid_of(const Json &json)
{
  Grid grid{size_of(json.at("size")), json.at("spacing_mm").get<Vec3>(), json.at("origin_mm").get<Vec3>(),
            json.at("direction").get<Mat3>()};
  if (json.contains("oversampling")) {
    require(integer_at(json, "oversampling", 1) <= kLargestOversampling, "oversampling");
    grid.oversampling = json["oversampling"].get<int>();
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    require(grid.spacing_mm[axis] > 0 && std::isfinite(grid.spacing_mm[axis]), "spacing_mm");
    require(std::isfinite(grid.origin_mm[axis]), "origin_mm");
  }
  require(std::isnormal(determinant(grid.direction)), "direction");
  return grid;
}

Json json_of(const Grid &grid)
{
  return {{"size", grid.size},
          {"spacing_mm", grid.spacing_mm},
          {"origin_mm", grid.origin_mm},
          {"direction", grid.direction},
          {"oversampling", grid.oversampling}};
}

Json source_json(const MergedVolume &merged)
{
  const InputVolume &input = merged.input;
  return {{"name", source_name(merged)},    {"bytes", input.source.bytes},     {"sha256", input.source.sha256},
          {"pixel_type", input.pixel_type}, {"series_uid", merged.series_uid}, {"warnings", input.warnings}};
}

void read_source(const Json &source, MergedVolume &merged)
{
  InputVolume &input = merged.input;
  input.source = {source.at("name").get<std::string>(), static_cast<std::uintmax_t>(integer_at(source, "bytes", 0)),
                  source.at("sha256").get<std::string>()};
  input.pixel_type = source.at("pixel_type").get<std::string>();
  input.warnings = source.at("warnings").get<std::vector<std::string>>();
  merged.series_uid = source.at("series_uid").get<std::string>();
}

void read_options(const Json &options, MergedVolume &merged)
{
  require(integer_at(options, "median_voxels", 0) <= kLargestMedian, "median_voxels");
  merged.median_voxels = options["median_voxels"].get<int>();
  if (!options.at("sigma_mm").is_null())
    merged.field.sigma_mm = options["sigma_mm"].get<double>();
  merged.field.edge_map = options.at("edge_map").get<bool>();
  const auto exterior = options.at("exterior").get<std::string>();
  require(exterior == "none" || exterior == "infinite", "exterior");
  merged.exterior = exterior == "none" ? Exterior::none : Exterior::infinite;
  try {
    EdgeField(merged.input.volume, merged.field);
  } catch (const UsageError &) {
    throw BadFact{"sigma_mm"};
  }
}

void read_hierarchy(const Json &hierarchy, MergedVolume &merged)
{
  constexpr std::int64_t kMost = std::numeric_limits<BasinId>::max();
  const auto basin = [&](const std::string &key) {
    require(integer_at(hierarchy, key, 0) <= kMost, key);
    return hierarchy[key].get<BasinId>();
  };
  merged.merge.hierarchy.background = basin("background");
  if (!hierarchy.at("exterior").is_null())
    merged.merge.hierarchy.exterior = basin("exterior");
  require(merged.merge.hierarchy.exterior.has_value() == (merged.exterior == Exterior::infinite), "exterior");
}

} // namespace

std::string facts_of(const MergedVolume &merged)
{
  const Hierarchy &hierarchy = merged.merge.hierarchy;
  const Json facts{
      {"version", version_text()},
      {"source", source_json(merged)},
      {"grid", json_of(merged.input.volume.grid)},
      {"options",
       {{"median_voxels", merged.median_voxels},
        {"sigma_mm", value_or_null(merged.field.sigma_mm)},
        {"edge_map", merged.field.edge_map},
        {"exterior", merged.exterior == Exterior::infinite ? "infinite" : "none"}}},
      {"non_finite_gradients", merged.non_finite_gradients},
      {"hierarchy", {{"background", hierarchy.background}, {"exterior", value_or_null(hierarchy.exterior)}}}};
  return facts.dump(-1, ' ', false, Json::error_handler_t::replace);
}

MergedVolume merged_volume_of(const std::string &facts, const std::filesystem::path &path)
{
  MergedVolume merged;
  try {
    const Json json = Json::parse(facts);
    merged.input.volume.grid = grid_of(json.at("grid"));
    read_source(json.at("source"), merged);
    read_options(json.at("options"), merged);
    read_hierarchy(json.at("hierarchy"), merged);
    merged.non_finite_gradients = integer_at(json, "non_finite_gradients", 0);
    return merged;
  } catch (const Json::exception &error) {
    throw InputError(path.string() + ": found facts that cannot be understood: " + error.what());
  } catch (const BadFact &bad) {
    throw InputError(path.string() + ": found a value of \"" + bad.what +
                     "\" that is out of range; allowed: " + "what --save-hierarchy wrote");
  }
}

} // namespace volsurf
