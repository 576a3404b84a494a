#include "command_line.h"

#include "volsurf/core/error.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <map>
#include <sstream>

namespace volsurf {

namespace {

/// What CLI11 fills in; the rest goes straight into Settings.
struct Texts {
  std::string delta;
  std::string keep;
  std::vector<std::string> seeds;
  std::string report;
  bool paper = false;
  bool quiet = false;
  bool verbose = false;
};

double parse_delta(const std::string &text)
{
  std::size_t used = 0;
  double delta = 0;
  try {
    delta = std::stod(text, &used);
  } catch (const std::logic_error &) {
    used = 0;
  }
  if (used == 0 || used != text.size() || !(delta > 0) || !std::isfinite(delta))
    throw UsageError("--delta: found \"" + text + "\"; allowed are finite numbers above 0, in intensity per mm");
  return delta;
}

Vec3 parse_seed(const std::string &text)
{
  Vec3 seed{};
  std::istringstream in(text);
  char comma1 = 0;
  char comma2 = 0;
  std::string rest;
  const bool read = static_cast<bool>(in >> seed[0] >> comma1 >> seed[1] >> comma2 >> seed[2]);
  if (!read || comma1 != ',' || comma2 != ',' || (in >> rest))
    throw UsageError("--seed: found \"" + text + "\"; allowed are three numbers X,Y,Z in mm");
  return seed;
}

/// INPUT's name without its extension, .vtp, in the current folder.
std::filesystem::path default_output(const std::filesystem::path &input)
{
  std::filesystem::path name = input.filename().empty() ? input.parent_path().filename() : input.filename();
  if (name.extension() == ".gz")
    name.replace_extension();
  return name.replace_extension(".vtp");
}

void add_field_options(CLI::App &app, Settings &settings, Texts &texts)
{
  app.add_option("--sigma", settings.field.sigma_mm,
                 "Gaussian for the gradient in mm; 0: central differences [one voxel: the smallest spacing]")
      ->group("Field");
  app.add_flag("--edge-map", settings.field.edge_map,
               "The input is an edge strength already (a gradient magnitude, a network's boundary map)")
      ->group("Field")
      ->excludes("--sigma");
  app.add_flag("--paper", texts.paper, "Exactly the paper: --sigma 0 --exterior infinite")
      ->group("Field")
      ->excludes("--sigma")
      ->excludes("--edge-map");
}

void add_topology_options(CLI::App &app, Settings &settings, Texts &texts)
{
  app.add_option("--delta", texts.delta, "Persistence that a boundary must reach, in intensity per mm")
      ->group("Topology")
      ->required();
  app.add_option("--exterior", settings.exterior, "What lies behind the border: none or infinite [none]")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Exterior>{{"none", Exterior::none}, {"infinite", Exterior::infinite}}))
      ->group("Topology")
      ->excludes("--paper");
}

void add_selection_options(CLI::App &app, Settings &settings, Texts &texts)
{
  app.add_option("--keep", texts.keep, "Components to keep, the largest first: 5%, a count, or all [all]")
      ->group("Selection");
  app.add_option("--rank-by", settings.components.rank_by,
                 "What makes a component large: faces, area or radius [faces]")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, RankBy>{{"faces", RankBy::faces}, {"area", RankBy::area}, {"radius", RankBy::radius}}))
      ->group("Selection");
  app.add_option("--surface", settings.surface,
                 "all: between all regions; hull: between the background and the rest [all]")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, SurfaceKind>{{"all", SurfaceKind::all}, {"hull", SurfaceKind::hull}}))
      ->group("Selection");
  app.add_option("--seed", texts.seeds,
                 "X,Y,Z in mm: only the boundary of the region that holds this point; repeatable")
      ->group("Selection")
      ->allow_extra_args(false);
}

void add_finishing_options(CLI::App &app, Settings &settings)
{
  app.add_option("--smooth", settings.smoothing.strength, "Smoothing, 0 (none) to 1 [0.5]")->group("Finishing");
  app.add_option("--iterations", settings.smoothing.iterations, "Smoothing passes [20 + 40 * smooth]")
      ->group("Finishing");
  app.add_option("--passband", settings.smoothing.pass_band, "Smoothing filter's pass band [10^(-4 * smooth)]")
      ->group("Finishing");
}

void add_output_options(CLI::App &app, Settings &settings, Texts &texts)
{
  app.add_option("-o,--output", settings.outputs,
                 "Output file, .vtp .stl .ply .obj or .vdb; repeatable [INPUT's name .vtp in this folder]")
      ->group("Output")
      ->allow_extra_args(false);
  app.add_option("--frame", settings.frame, "World frame of outputs and seeds: lps or ras [lps]")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Frame>{{"lps", Frame::lps}, {"ras", Frame::ras}}))
      ->group("Output");
  app.add_option("--labels", settings.labels, "Write the region of each cell as .nrrd")->group("Output");
  app.add_option("--report", texts.report, "Write a report as JSON; - for standard output")->group("Output");
}

void add_general_options(CLI::App &app, Settings &settings, Texts &texts)
{
  app.add_option("--series", settings.series_uid, "UID of the DICOM series to read, where a folder holds several")
      ->group("General");
  app.add_option("--threads", settings.threads, "Threads; 0: all [0]")->group("General")->check(CLI::Range(0, 1024));
  app.add_flag("-q,--quiet", texts.quiet, "Print errors only")->group("General");
  app.add_flag("-v,--verbose", texts.verbose, "Print what each stage found and took")->group("General")->excludes("-q");
  app.set_version_flag("--version", version_text())->group("General");
  app.set_config("--config", "", "Read options from a file, as delta = 20")->group("General");
}

void finish(const Texts &texts, CommandLine &line)
{
  Settings &settings = line.settings;
  settings.delta = parse_delta(texts.delta);
  if (!texts.keep.empty())
    settings.components.keep = parse_keep(texts.keep);
  for (const std::string &seed : texts.seeds)
    settings.seeds_mm.push_back(parse_seed(seed));
  if (texts.paper) {
    settings.field.sigma_mm = 0;
    settings.exterior = Exterior::infinite;
  }
  line.report_to_stdout = texts.report == "-";
  if (!texts.report.empty() && !line.report_to_stdout)
    settings.report = texts.report;
  if (settings.outputs.empty())
    settings.outputs.push_back(default_output(settings.input));
  line.verbosity = texts.quiet ? Verbosity::quiet : texts.verbose ? Verbosity::verbose : Verbosity::normal;
}

EarlyExit early_exit_of(const CLI::App &app, const CLI::ParseError &error)
{
  std::ostringstream out;
  std::ostringstream err;
  const int code = app.exit(error, out, err);
  if (code == 0)
    return {0, out.str()};
  std::string line = error.what();
  for (char &c : line)
    c = c == '\n' ? ' ' : c;
  return {2, line + " (see volsurf --help)"};
}

} // namespace

ParsedCommandLine parse_command_line(int argc, const char *const *argv)
{
  ParsedCommandLine parsed;
  Texts texts;
  Settings &settings = parsed.command_line.settings;
  CLI::App app("Surfaces of a noisy volume, without an iso-value: the walls whose contrast per millimetre\n"
               "stays above delta even at their weakest point.\n\n"
               "Inputs: NRRD, NHDR, MHA, MHD, NIfTI, a DICOM folder. World coordinates are millimetres.\n"
               "Exit codes: 0 done, 1 unexpected, 2 usage, 3 input, 4 nothing to write, 5 output, 130 interrupted.",
               "volsurf");
  app.add_option("INPUT", settings.input, "The scan")->required();
  add_field_options(app, settings, texts);
  add_topology_options(app, settings, texts);
  add_selection_options(app, settings, texts);
  add_finishing_options(app, settings);
  add_output_options(app, settings, texts);
  add_general_options(app, settings, texts);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError &error) {
    parsed.early_exit = early_exit_of(app, error);
    return parsed;
  }
  finish(texts, parsed.command_line);
  return parsed;
}

} // namespace volsurf
