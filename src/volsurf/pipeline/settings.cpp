#include "volsurf/pipeline/settings.h"

#include <sstream>

namespace volsurf {

namespace {

struct KeepText {
  std::ostringstream &out;

  void operator()(const KeepAll &) const { out << "all"; }
  void operator()(const KeepCount &keep) const { out << keep.count; }
  void operator()(const KeepPercent &keep) const { out << keep.percent << '%'; }
};

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

std::string describe(const Settings &settings, double delta)
{
  std::ostringstream out;
  out.precision(9);
  out << delta_text(DeltaValue{delta});
  if (settings.median_voxels.value_or(0) > 0)
    out << " --median " << *settings.median_voxels;
  if (settings.field.edge_map)
    out << " --edge-map";
  else if (settings.field.sigma_mm)
    out << " --sigma " << *settings.field.sigma_mm;
  out << " --exterior " << (settings.exterior == Exterior::infinite ? "infinite" : "none");
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
