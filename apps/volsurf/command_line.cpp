#include "command_line.h"

#include "shared_options.h"

#include "volsurf/baseline/cgal_mesher.h"
#include "volsurf/core/error.h"

#include <cmath>
#include <sstream>
#include <utility>

namespace volsurf {

namespace {

/// What CLI11 fills in; the rest goes straight into Settings. An empty text is an option that was not given.
struct Texts : SharedTexts {
  std::string delta;
  std::optional<std::int64_t> regions;
  std::string iso;
  std::string keep;
  std::vector<std::string> seeds;
  std::vector<std::string> region_numbers;
  std::string report;
};

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

std::int64_t parse_region(const std::string &text)
{
  constexpr std::size_t kMostDigits = 18;
  const bool digits = text.find_first_not_of("0123456789") == std::string::npos;
  const std::int64_t number = digits && text.size() <= kMostDigits ? std::stoll(text) : 0;
  if (number < 1)
    throw UsageError("--region: found \"" + text + "\"; allowed are whole numbers from 1");
  return number;
}

/// INPUT's name without its extension, .vtp, in the current folder. A folder's name has no extension, only dots.
std::filesystem::path default_output(const std::filesystem::path &input)
{
  std::error_code error;
  if (std::filesystem::is_directory(input, error)) {
    const auto folder = std::filesystem::canonical(input, error).filename();
    return (folder.empty() ? "volume" : folder.string()) + ".vtp";
  }
  std::filesystem::path name = input.filename();
  if (name.extension() == ".gz" || name.extension() == ".GZ")
    name.replace_extension();
  return name.replace_extension(".vtp");
}

std::string method_help()
{
  return std::string("volsurf, or to compare: threshold, isosurface, marching-cubes, watershed, cgal-mesher ") +
         (has_cgal_mesher() ? "(with CGAL) " : "(not in this program, which is built without CGAL) ") + "[volsurf]";
}

void add_method_options(CLI::App &app, Settings &settings, Texts &texts)
{
  add_word_option<Method>(app, "--method", settings.method,
                          {{"volsurf", Method::volsurf},
                           {"threshold", Method::threshold},
                           {"isosurface", Method::isosurface},
                           {"marching-cubes", Method::marching_cubes},
                           {"cgal-mesher", Method::cgal_mesher},
                           {"watershed", Method::watershed}},
                          method_help())
      ->group("Method");
  app.add_option("--iso", texts.iso, "Iso-value of these but watershed: a number, or otsu [otsu]")->group("Method");
}

/// Nothing for "otsu".
std::optional<double> parse_iso(const std::string &text)
{
  if (text == "otsu")
    return std::nullopt;
  std::istringstream in(text);
  double iso = 0;
  std::string rest;
  if (!(in >> iso) || (in >> rest))
    throw UsageError("--iso: found \"" + text + "\"; allowed are otsu and finite numbers");
  return iso;
}

/// Words that settings do not tell from defaults are refused here, the rest where the run begins.
void refuse_given(const CLI::App &app, Method method, const std::vector<std::string> &options)
{
  for (const std::string &option : options)
    if (app.count(option) > 0)
      throw UsageError("--method " + method_text(method) + ": found " + option + ", which means nothing to it");
}

/// What usual methods have other defaults for.
void finish_method(const CLI::App &app, Settings &settings)
{
  const Method method = settings.method;
  refuse_given(app, method,
               takes_iso_value(method) ? std::vector<std::string>{"--delta"} : std::vector<std::string>{"--iso"});
  if (method == Method::volsurf)
    return;
  refuse_given(app, method, {"--paper"});
  if (settings.snap)
    refuse_given(app, method, {"--snap"});
  settings.snap = false;
  const bool wants_smoothing = app.count("--smooth") + app.count("--iterations") + app.count("--passband") > 0;
  if (!finds_regions(method) && !wants_smoothing)
    settings.smoothing.strength = 0;
}

void add_topology_options(CLI::App &app, Settings &settings, Texts &texts)
{
  CLI::Option *const delta =
      app.add_option("--delta", texts.delta,
                     "Persistence that a boundary must reach: D in intensity per mm, D% of the largest, or auto [auto]")
          ->group("Topology");
  app.add_option("--regions", texts.regions, "Choose delta so that this many regions are left")
      ->group("Topology")
      ->check(CLI::Range(std::int64_t{2}, std::int64_t{1} << 31))
      ->excludes(delta);
  add_exterior_option(app, settings);
}

void add_selection_options(CLI::App &app, Settings &settings, Texts &texts)
{
  app.add_option("--keep", texts.keep, "Components to keep, the largest first: 5%, a count, or all [all]")
      ->group("Selection");
  add_word_option<RankBy>(app, "--rank-by", settings.components.rank_by,
                          {{"faces", RankBy::faces}, {"area", RankBy::area}, {"radius", RankBy::radius}},
                          "What makes a component large: faces, area or radius [faces]")
      ->group("Selection");
  add_word_option<SurfaceKind>(
      app, "--surface", settings.surface, {{"all", SurfaceKind::all}, {"hull", SurfaceKind::hull}},
      "all: between all regions; hull: between the background with its furrows and the rest [all]")
      ->group("Selection");
  app.add_option("--seed", texts.seeds,
                 "X,Y,Z in mm: only the boundary of the region that holds this point; repeatable")
      ->group("Selection")
      ->allow_extra_args(false);
  app.add_option("--region", texts.region_numbers, "Only the boundary of the region of this number; repeatable")
      ->group("Selection")
      ->allow_extra_args(false);
  app.add_option("--min-volume", settings.min_volume_mm3,
                 "Only the boundaries of regions (hull: of islands) at least this large, in mm3 [0]")
      ->group("Selection");
}

void add_finishing_options(CLI::App &app, Settings &settings)
{
  app.add_option("--smooth", settings.smoothing.strength, "Smoothing, 0 (none) to 1 [0.5; of an isosurface 0]")
      ->group("Finishing");
  add_word_option<bool>(app, "--snap", settings.snap, {{"on", true}, {"off", false}},
                        "Move points to the edge between samples: on or off; needs smoothing [on]")
      ->group("Finishing");
  app.add_option("--iterations", settings.smoothing.iterations, "Smoothing passes [20 + 20 * smooth]")
      ->group("Finishing");
  app.add_option("--passband", settings.smoothing.pass_band, "Smoothing filter's pass band [10^(-1 - 0.7 * smooth)]")
      ->group("Finishing");
}

void add_output_options(CLI::App &app, Settings &settings, Texts &texts)
{
  app.add_option("-o,--output", settings.outputs,
                 "Output file, .vtp .stl .ply .obj or .vdb; repeatable [INPUT's name .vtp in this folder]")
      ->group("Output")
      ->allow_extra_args(false);
  add_word_option<Split>(
      app, "--split", settings.split,
      {{"none", Split::none}, {"components", Split::components}, {"regions", Split::regions}},
      "A file for each: none, components (FILE_component_3) or regions (FILE_region_17, closed) [none]")
      ->group("Output");
  add_word_option<Frame>(app, "--frame", settings.frame, {{"lps", Frame::lps}, {"ras", Frame::ras}},
                         "World frame of outputs and seeds: lps or ras [lps]")
      ->group("Output");
  app.add_option("--labels", settings.labels, "Write the region of each cell as .nrrd, or as .seg.nrrd for 3D Slicer")
      ->group("Output");
  app.add_option("--save-hierarchy", settings.hierarchy,
                 "Write all that further cuts need as .volsurf, which stands for the scan as INPUT")
      ->group("Output");
  app.add_option("--report", texts.report, "Write a report as JSON; - for standard output")->group("Output");
}

void add_config_option(CLI::App &app)
{
  app.set_config("--config", "", "Read options from a file of lines such as delta = 20; the command line wins")
      ->group("General");
  app.allow_config_extras(false);
  // Values hold commas (seed = 0,0,0) and blanks (output = my scan.vtp); what repeats is a line of its own.
  app.get_config_formatter_base()->arrayDelimiter(';');
}

void finish(const Texts &texts, CommandLine &line)
{
  Settings &settings = line.settings;
  if (!texts.delta.empty())
    settings.delta = parse_delta(texts.delta);
  if (!texts.iso.empty())
    settings.iso = parse_iso(texts.iso);
  if (texts.regions)
    settings.delta = DeltaRegions{*texts.regions};
  if (!texts.keep.empty())
    settings.components.keep = parse_keep(texts.keep);
  for (const std::string &seed : texts.seeds)
    settings.seeds_mm.push_back(parse_seed(seed));
  for (const std::string &region : texts.region_numbers)
    settings.region_numbers.push_back(parse_region(region));
  finish_shared(texts, settings);
  line.report_to_stdout = texts.report == "-";
  if (!texts.report.empty() && !line.report_to_stdout)
    settings.report = texts.report;
  if (settings.outputs.empty())
    settings.outputs.push_back(default_output(settings.input));
  line.verbosity = verbosity_of(texts);
}

} // namespace

ParsedCommandLine parse_command_line(int argc, const char *const *argv)
{
  ParsedCommandLine parsed;
  Texts texts;
  Settings &settings = parsed.command_line.settings;
  CLI::App app("Surfaces of a noisy volume, without an iso-value: the walls whose contrast per millimetre\n"
               "stays above delta even at their weakest point.\n\n"
               "Inputs: NRRD, NHDR, MHA, MHD, NIfTI, a DICOM folder, a file of --save-hierarchy. World coordinates are "
               "millimetres.\n"
               "volsurf explore INPUT shows what each delta would give (see volsurf explore --help).\n"
               "Exit codes: 0 done, 1 unexpected, 2 usage, 3 input, 4 nothing to write, 5 output, 130 interrupted.",
               "volsurf");
  app.add_option("INPUT", settings.input, "The scan")->required();
  add_method_options(app, settings, texts);
  add_field_options(app, settings, texts);
  add_topology_options(app, settings, texts);
  add_selection_options(app, settings, texts);
  add_finishing_options(app, settings);
  add_output_options(app, settings, texts);
  add_general_options(app, settings, texts);
  add_config_option(app);
  parsed.early_exit = parse_arguments(app, argc, argv);
  if (parsed.early_exit)
    return parsed;
  finish(texts, parsed.command_line);
  finish_method(app, settings);
  return parsed;
}

} // namespace volsurf
