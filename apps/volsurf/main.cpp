// volsurf: from a scan to its surfaces.

#include "command_line.h"
#include "explore_command.h"
#include "explore_command_line.h"
#include "program/program.h"
#include "progress_bar.h"

#include "volsurf/pipeline/merged_volume.h"
#include "volsurf/pipeline/run.h"

#include <algorithm>
#include <iostream>
#include <sstream>

namespace {

using volsurf::one_line;
using volsurf::print;

/// A line for each format.
void print_split(const volsurf::Report &report)
{
  const auto &surfaces = report.surfaces;
  const auto watertight =
      std::count_if(surfaces.begin(), surfaces.end(), [](const auto &surface) { return surface.mesh.watertight; });
  for (std::size_t format = 0; format < surfaces.front().files.size(); ++format) {
    std::cerr << one_line(surfaces.front().files[format].string());
    if (surfaces.size() > 1)
      std::cerr << " to " << one_line(surfaces.back().files[format].string());
    std::cerr << ": " << report.mesh.triangles << " triangles in " << surfaces.size()
              << (surfaces.size() == 1 ? " file, " : " files, ") << watertight << " of them watertight\n";
  }
}

/// Where the surface is.
std::string place_text(const volsurf::Report &report)
{
  std::ostringstream out;
  if (takes_iso_value(report.settings.method))
    out << "at the iso-value " << *report.settings.iso;
  else
    out << "between " << report.regions << " regions at delta " << report.decision.delta
        << (report.grid.oversampling > 1 ? " on a grid twice as fine" : "");
  return out.str();
}

void print_summary(const volsurf::Report &report, volsurf::Verbosity verbosity)
{
  if (verbosity == volsurf::Verbosity::quiet)
    return;
  for (const std::string &warning : report.warnings)
    std::cerr << "volsurf: warning: " << one_line(warning) << '\n';
  if (report.settings.split != volsurf::Split::none)
    return print_split(report);
  for (const auto &output : report.settings.outputs)
    std::cerr << one_line(output.string()) << ": " << report.mesh.triangles << " triangles in "
              << report.components_kept << " of " << report.components << " components, " << place_text(report)
              << (report.mesh.watertight ? ", watertight" : "") << '\n';
}

void print_expectation(const volsurf::Grid &grid, volsurf::Method method, std::ostream &out)
{
  out << "volume      " << grid.size[0] << " x " << grid.size[1] << " x " << grid.size[2] << " samples of "
      << grid.spacing_mm[0] << " x " << grid.spacing_mm[1] << " x " << grid.spacing_mm[2] << " mm"
      << (grid.oversampling > 1 ? ", twice as fine as the scan\n" : "\n") << "memory      "
      << static_cast<double>(volsurf::expected_memory_bytes(grid, method)) / 1e6 << " MB expected without the mesh\n";
}

void print_advice(const volsurf::DeltaAdvice &advice)
{
  std::cerr << "noise       standard deviation " << advice.noise.volume << ", makes walls of at most "
            << advice.noise_floor << " per mm\n";
  for (const volsurf::DeltaCandidate &candidate : advice.candidates)
    std::cerr << "candidate   delta " << candidate.delta << " leaves " << candidate.regions
              << " regions; little changes from " << candidate.low << " to " << candidate.high << '\n';
}

void print_merge(const volsurf::Report &report)
{
  std::cerr << "field       " << report.pixel_type << " samples, sigma " << report.sigma_mm << " mm\n"
            << "merge       " << report.basins << " basins, largest persistence " << report.largest_persistence << '\n'
            << "delta       " << report.decision.delta << ", from " << delta_text(report.settings.delta) << '\n';
  if (report.decision.advice)
    print_advice(*report.decision.advice);
  std::cerr << "regions     " << report.regions << ", the background is region " << report.background_region << '\n';
}

void print_details(const volsurf::Report &report)
{
  if (report.settings.method == volsurf::Method::volsurf)
    print_merge(report);
  else
    std::cerr << "method      " << method_text(report.settings.method) << ", " << place_text(report) << '\n';
  std::cerr << "mesh        area " << report.mesh.area_mm2 << " mm2, volume " << report.mesh.volume_mm3 << " mm3, "
            << report.mesh.open_edges << " open and " << report.mesh.non_manifold_edges << " non-manifold edges\n"
            << "smoothing   " << report.smoothing.iterations << " passes at pass band " << report.smoothing.pass_band
            << ", volume drift " << 100 * report.smoothing.volume_drift << " %\n";
  if (report.snap)
    std::cerr << "snap        " << report.snap->moved << " points to their edge, " << report.snap->followed
              << " with their neighbours, " << report.snap->rejected << " rejected, "
              << report.snap->root_mean_square_mm << " mm (root mean square)\n";
  for (const auto &[stage, seconds] : report.seconds)
    std::cerr << "time        " << stage << ' ' << seconds << " s\n";
  std::cerr << "memory      " << static_cast<double>(report.peak_memory_bytes) / 1e6 << " MB at most, "
            << report.threads << " threads\n";
}

int run_command(const volsurf::CommandLine &line)
{
  const bool verbose = line.verbosity == volsurf::Verbosity::verbose;
  volsurf::Report report;
  {
    volsurf::ProgressBar bar(line.verbosity != volsurf::Verbosity::quiet);
    const auto show = [&](std::string_view stage, double fraction) {
      bar.show(stage, fraction);
      return !volsurf::was_interrupted();
    };
    const auto publish = [&](const volsurf::Report &complete) {
      bar.wipe();
      if (line.report_to_stdout)
        print(volsurf::to_json(complete));
    };
    std::ostream messages(std::cerr.rdbuf()); // std::cerr itself is silenced while ITK reads
    const auto announce = [&](const volsurf::Grid &grid) {
      bar.wipe();
      if (verbose)
        print_expectation(grid, line.settings.method, messages);
    };
    report = volsurf::run(line.settings, show, publish, announce);
  }
  print_summary(report, line.verbosity);
  if (verbose)
    print_details(report);
  return 0;
}

int exit_early(const volsurf::EarlyExit &early_exit)
{
  if (early_exit.code != volsurf::kDone)
    return volsurf::fail("volsurf", early_exit.code, early_exit.text);
  print(early_exit.text);
  return 0;
}

int extract_surfaces(int argc, const char *const *argv)
{
  const auto parsed = volsurf::parse_command_line(argc, argv);
  return parsed.early_exit ? exit_early(*parsed.early_exit) : run_command(parsed.command_line);
}

int explore_scan(int argc, const char *const *argv)
{
  const auto parsed = volsurf::parse_explore_command_line(argc, argv);
  return parsed.early_exit ? exit_early(*parsed.early_exit) : volsurf::run_explore_command(parsed.command_line);
}

} // namespace

int main(int argc, char **argv)
{
  volsurf::catch_interrupts();
  volsurf::ignore_closed_pipes();
  try {
    if (volsurf::is_explore_command(argc, argv))
      return explore_scan(argc - 1, argv + 1);
    return extract_surfaces(argc, argv);
  } catch (...) {
    return volsurf::fail_of_exception("volsurf");
  }
}
