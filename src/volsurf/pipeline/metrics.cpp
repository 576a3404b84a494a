#include "volsurf/pipeline/metrics.h"

#include "volsurf/core/error.h"

#include <algorithm>
#include <cstdlib>
#include <regex>

namespace volsurf {

namespace {

using Value = std::optional<double>;

template <double SurfaceDistances::*Member> Value of_both(const Comparison &c)
{
  return c.distances.*Member;
}

template <double DirectedDistances::*Member> Value of_a_to_b(const Comparison &c)
{
  return c.distances.a_to_b.*Member;
}

template <double DirectedDistances::*Member> Value of_b_to_a(const Comparison &c)
{
  return c.distances.b_to_a.*Member;
}

template <double VertexDistances::*Member> Value of_vertices(const Comparison &c)
{
  return c.vertices.*Member;
}

template <double Overlap::*Member> Value of_overlap(const Comparison &c)
{
  return c.overlap ? Value((*c.overlap).*Member) : std::nullopt;
}

Value bias(const Comparison &c)
{
  return c.a_is_closed && c.b_is_closed ? Value(c.distances.bias_mm) : std::nullopt;
}

Value bias_a_to_b(const Comparison &c)
{
  return c.b_is_closed ? Value(c.distances.a_to_b.signed_mean_mm) : std::nullopt;
}

Value bias_b_to_a(const Comparison &c)
{
  return c.a_is_closed ? Value(c.distances.b_to_a.signed_mean_mm) : std::nullopt;
}

Value volume_error(const Comparison &c)
{
  if (!c.volume_a_mm3 || !c.volume_b_mm3)
    return std::nullopt;
  return (*c.volume_a_mm3 - *c.volume_b_mm3) / *c.volume_b_mm3;
}

std::string names_of_metrics()
{
  std::string names;
  for (const Metric &metric : metrics())
    names += (names.empty() ? "" : ", ") + std::string(metric.name);
  return names;
}

} // namespace

const std::vector<Metric> &metrics()
{
  using Directed = DirectedDistances;
  using Both = SurfaceDistances;
  static const std::vector<Metric> all{
      {"assd", "mm", of_both<&Both::assd_mm>},
      {"rms", "mm", of_both<&Both::rms_mm>},
      {"hd95", "mm", of_both<&Both::hd95_mm>},
      {"hausdorff", "mm", of_both<&Both::hausdorff_mm>},
      {"bias", "mm", bias},
      {"surface_dice", "", of_both<&Both::surface_dice>},
      {"mean_a_to_b", "mm", of_a_to_b<&Directed::mean_mm>},
      {"mean_b_to_a", "mm", of_b_to_a<&Directed::mean_mm>},
      {"rms_a_to_b", "mm", of_a_to_b<&Directed::rms_mm>},
      {"rms_b_to_a", "mm", of_b_to_a<&Directed::rms_mm>},
      {"p95_a_to_b", "mm", of_a_to_b<&Directed::percentile95_mm>},
      {"p95_b_to_a", "mm", of_b_to_a<&Directed::percentile95_mm>},
      {"max_a_to_b", "mm", of_a_to_b<&Directed::maximum_mm>},
      {"max_b_to_a", "mm", of_b_to_a<&Directed::maximum_mm>},
      {"bias_a_to_b", "mm", bias_a_to_b},
      {"bias_b_to_a", "mm", bias_b_to_a},
      {"within_a_to_b", "", of_a_to_b<&Directed::area_within>},
      {"within_b_to_a", "", of_b_to_a<&Directed::area_within>},
      {"area_a", "mm2", of_a_to_b<&Directed::area_mm2>},
      {"area_b", "mm2", of_b_to_a<&Directed::area_mm2>},
      {"dice", "", of_overlap<&Overlap::dice>},
      {"jaccard", "", of_overlap<&Overlap::jaccard>},
      {"volume_a", "mm3", [](const Comparison &c) { return c.volume_a_mm3; }},
      {"volume_b", "mm3", [](const Comparison &c) { return c.volume_b_mm3; }},
      {"volume_error", "", volume_error},
      {"mse", "mm2", of_vertices<&VertexDistances::mse_mm2>},
      {"snr", "dB", of_vertices<&VertexDistances::snr_db>},
      {"mae", "mm", of_vertices<&VertexDistances::mae_mm>},
      {"vertex_hausdorff", "mm", of_vertices<&VertexDistances::hausdorff_mm>},
  };
  return all;
}

Requirement parse_requirement(const std::string &text)
{
  static const std::regex form(R"(\s*(\w+)\s*(<=|>=|<|>)\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*)");
  std::smatch parts;
  if (!std::regex_match(text, parts, form))
    throw UsageError("--require: found \"" + text +
                     "\"; allowed are a metric, <, <=, > or >=, and a number, as "
                     "\"dice>=0.95\"");
  const auto metric =
      std::find_if(metrics().begin(), metrics().end(), [&](const Metric &m) { return m.name == parts[1]; });
  if (metric == metrics().end())
    throw UsageError("--require: found the metric \"" + parts[1].str() + "\"; allowed are " + names_of_metrics());
  const std::string sign = parts[2];
  const Relation relation = sign == "<"    ? Relation::less
                            : sign == "<=" ? Relation::at_most
                            : sign == ">"  ? Relation::greater
                                           : Relation::at_least;
  return {text, &*metric, relation, std::strtod(parts[3].str().c_str(), nullptr)};
}

bool is_met(const Requirement &requirement, const Comparison &comparison)
{
  const std::optional<double> value = requirement.metric->value(comparison);
  if (!value)
    return false;
  switch (requirement.relation) {
  case Relation::less:
    return *value < requirement.bound;
  case Relation::at_most:
    return *value <= requirement.bound;
  case Relation::greater:
    return *value > requirement.bound;
  case Relation::at_least:
    break;
  }
  return *value >= requirement.bound;
}

} // namespace volsurf
