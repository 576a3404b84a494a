#include "volsurf/pipeline/comparison_report.h"

#include "volsurf/pipeline/settings.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace volsurf {

namespace {

using Json = nlohmann::ordered_json;
using Value = std::optional<double>;

constexpr int kNameWidth = 26;
constexpr int kValueWidth = 12;

std::string number(const Value &value)
{
  if (!value)
    return "-";
  std::ostringstream text;
  text << std::setprecision(4) << *value;
  return text.str();
}

Value metric(const ComparedFiles &files, const std::string &name)
{
  for (const Metric &m : metrics())
    if (m.name == name)
      return m.value(files.comparison);
  return std::nullopt;
}

std::string frame_text(const ComparedFile &file)
{
  return frame_name(file.frame) + (file.frame_is_assumed ? " (assumed, the file names no frame)" : "");
}

std::string labels_text(const std::vector<float> &labels)
{
  if (labels.empty())
    return "all above 0";
  std::ostringstream text;
  for (std::size_t i = 0; i < labels.size(); ++i)
    text << (i > 0 ? ", " : "") << labels[i];
  return text.str();
}

std::string description(const ComparedFile &file, const CompareSettings &settings)
{
  const Shape &shape = file.shape;
  const std::string size = std::to_string(shape.surface.triangles.size()) + " triangles";
  if (shape.mask)
    return "labels " + labels_text(settings.labels) + ", " + std::to_string(count_inside(*shape.mask)) +
           " voxels; surface half-way between the samples inside and outside, " + size;
  return "surface, " + size + ", " + (shape.is_closed() ? "closed" : "not closed") + ", " + frame_text(file);
}

void add_cells(std::ostream &out, const std::string &name, const std::vector<std::string> &cells)
{
  out << "  " << std::left << std::setw(kNameWidth) << name << std::right;
  for (const std::string &cell : cells)
    out << std::setw(kValueWidth) << cell;
  out << '\n';
}

void add_distances(std::ostream &out, const ComparedFiles &files)
{
  const auto add = [&](const std::string &name, const char *a_to_b, const char *b_to_a, const char *both,
                       const std::string &word) {
    add_cells(out, name, {number(metric(files, a_to_b)), number(metric(files, b_to_a)), number(metric(files, both))});
    out.seekp(-1, std::ios::cur);
    out << "  " << word << '\n';
  };
  add_cells(out, "distances, mm", {"A to B", "B to A", "both"});
  add("mean", "mean_a_to_b", "mean_b_to_a", "assd", "assd");
  add("root mean square", "rms_a_to_b", "rms_b_to_a", "rms", "rms");
  add("95 % of the area within", "p95_a_to_b", "p95_b_to_a", "hd95", "hd95");
  add("maximum", "max_a_to_b", "max_b_to_a", "hausdorff", "hausdorff");
  add("signed mean, + outside", "bias_a_to_b", "bias_b_to_a", "bias", "bias, + where A is outside of B");
  add("area within " + number(files.comparison.tolerance_mm) + " mm", "within_a_to_b", "within_b_to_a", "surface_dice",
      "surface_dice");
}

void add_volumes(std::ostream &out, const ComparedFiles &files)
{
  const auto litres = [](const Value &mm3) { return mm3 ? Value(*mm3 / 1000) : std::nullopt; };
  add_cells(out, "", {"A", "B", "error"});
  add_cells(out, "volume, ml",
            {number(litres(metric(files, "volume_a"))), number(litres(metric(files, "volume_b"))),
             number(metric(files, "volume_error"))});
  add_cells(out, "dice", {number(metric(files, "dice"))});
  add_cells(out, "jaccard", {number(metric(files, "jaccard"))});
}

void add_vertices(std::ostream &out, const ComparedFiles &files)
{
  add_cells(out, "vertices only", {"mse, mm2", "snr, dB", "mae, mm", "hausdorff"});
  add_cells(out, "",
            {number(metric(files, "mse")), number(metric(files, "snr")), number(metric(files, "mae")),
             number(metric(files, "vertex_hausdorff"))});
}

/// JSON knows no infinity: null stands for it.
Json finite_or_null(const Value &value)
{
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json file_json(const ComparedFile &file, const CompareSettings &settings)
{
  const Shape &shape = file.shape;
  const bool is_mask = shape.mask.has_value();
  return {{"path", file.path.string()},
          {"kind", is_mask ? "labels" : "surface"},
          {"labels", is_mask ? Json(settings.labels) : Json(nullptr)},
          {"voxels", is_mask ? Json(count_inside(*shape.mask)) : Json(nullptr)},
          {"frame", frame_name(file.frame)},
          {"frame_is_assumed", file.frame_is_assumed},
          {"points", shape.surface.points.size()},
          {"triangles", shape.surface.triangles.size()},
          {"closed", shape.is_closed()},
          {"unbalanced_edges", shape.unbalanced_edges}};
}

Json metrics_json(const Comparison &comparison)
{
  Json json = Json::object();
  for (const Metric &m : metrics())
    json[m.name] = finite_or_null(m.value(comparison));
  return json;
}

Json requirements_json(const ComparedFiles &files)
{
  Json json = Json::array();
  for (const Requirement &requirement : files.settings.requirements)
    json.push_back({{"require", requirement.text},
                    {"value", finite_or_null(requirement.metric->value(files.comparison))},
                    {"met", is_met(requirement, files.comparison)}});
  return json;
}

Json warnings_json(const ComparedFiles &files)
{
  Json json = Json::array();
  for (const auto *warnings : {&files.a.warnings, &files.b.warnings, &files.comparison.warnings})
    for (const std::string &warning : *warnings)
      json.push_back(warning);
  return json;
}

} // namespace

std::string to_table(const ComparedFiles &files)
{
  std::ostringstream out;
  out << "A  " << files.a.path.string() << ": " << description(files.a, files.settings) << '\n'
      << "B  " << files.b.path.string() << ": " << description(files.b, files.settings) << "\n\n";
  add_distances(out, files);
  out << '\n';
  add_volumes(out, files);
  out << '\n';
  add_vertices(out, files);
  return out.str();
}

std::string to_json(const ComparedFiles &files)
{
  const std::optional<Overlap> &overlap = files.comparison.overlap;
  const Json json{{"program", version_text()},
                  {"a", file_json(files.a, files.settings)},
                  {"b", file_json(files.b, files.settings)},
                  {"tolerance_mm", files.comparison.tolerance_mm},
                  {"samples", files.settings.options.samples},
                  {"overlap_spacing_mm", overlap ? Json(overlap->spacing_mm) : Json(nullptr)},
                  {"metrics", metrics_json(files.comparison)},
                  {"requirements", requirements_json(files)},
                  {"warnings", warnings_json(files)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string failure_text(const Requirement &requirement, const Comparison &comparison)
{
  const Value value = requirement.metric->value(comparison);
  return "--require " + requirement.text + " is not met: " + requirement.metric->name +
         (value ? " is " + number(value) : " has no value, since a surface is not closed");
}

} // namespace volsurf
