#include "volsurf/pipeline/settings.h"

#include "volsurf/core/timer.h"

#include <sstream>

namespace volsurf {

namespace {

struct KeepText {
  std::ostringstream &out;

  void operator()(const KeepAll &) const { out << "all"; }
  void operator()(const KeepCount &keep) const { out << keep.count; }
  void operator()(const KeepPercent &keep) const { out << keep.percent << '%'; }
};

/// What decides where a surface can be: the method and the options of its own.
void describe_method(const Settings &settings, double delta, std::ostream &out)
{
  const bool by_iso_value = takes_iso_value(settings.method);
  if (settings.method != Method::volsurf)
    out << "--method " << method_text(settings.method) << ' ';
  if (by_iso_value)
    out << "--iso " << settings.iso.value_or(0);
  else
    out << delta_text(DeltaValue{delta});
  if (settings.median_voxels.value_or(0) > 0)
    out << " --median " << *settings.median_voxels;
  if (settings.oversampling.value_or(1) > 1)
    out << " --oversample " << *settings.oversampling;
  if (!by_iso_value && settings.field.edge_map)
    out << " --edge-map";
  else if (!by_iso_value && settings.field.sigma_mm)
    out << " --sigma " << *settings.field.sigma_mm;
  if (settings.method == Method::volsurf)
    out << " --exterior " << (settings.exterior == Exterior::infinite ? "infinite" : "none");
}

} // namespace

std::string keep_text(const Keep &keep)
{
  std::ostringstream out;
  out.precision(9);
  std::visit(KeepText{out}, keep);
  return out.str();
}

std::string rank_by_text(RankBy rank_by)
{
  switch (rank_by) {
  case RankBy::area:
    return "area";
  case RankBy::radius:
    return "radius";
  case RankBy::faces:
    break;
  }
  return "faces";
}

std::string split_text(Split split)
{
  switch (split) {
  case Split::components:
    return "components";
  case Split::regions:
    return "regions";
  case Split::none:
    break;
  }
  return "none";
}

std::uint64_t allowed_memory_bytes(const Settings &settings)
{
  return settings.max_memory_bytes.value_or(available_memory_bytes());
}

std::string describe(const Settings &settings, double delta)
{
  std::ostringstream out;
  out.precision(9);
  describe_method(settings, delta, out);
  if (settings.surface == SurfaceKind::hull)
    out << " --surface hull";
  for (const Vec3 &seed : settings.seeds_mm)
    out << " --seed " << seed[0] << ',' << seed[1] << ',' << seed[2];
  for (const std::int64_t number : settings.region_numbers)
    out << " --region " << number;
  if (settings.min_volume_mm3 > 0)
    out << " --min-volume " << settings.min_volume_mm3;
  out << " --keep " << keep_text(settings.components.keep) << " --rank-by "
      << rank_by_text(settings.components.rank_by);
  out << " --smooth " << settings.smoothing.strength;
  if (settings.method == Method::volsurf)
    out << " --snap " << (settings.snap ? "on" : "off");
  if (settings.smoothing.iterations)
    out << " --iterations " << *settings.smoothing.iterations;
  if (settings.smoothing.pass_band)
    out << " --passband " << *settings.smoothing.pass_band;
  if (settings.split != Split::none)
    out << " --split " << split_text(settings.split);
  out << " --frame " << (settings.frame == Frame::ras ? "ras" : "lps");
  return out.str();
}

std::string version_text()
{
  return "volsurf " VOLSURF_VERSION;
}

} // namespace volsurf
