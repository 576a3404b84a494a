// volsurf-compare: how far two surfaces or label volumes are from each other.
#include "program/program.h"

#include "volsurf/core/error.h"
#include "volsurf/pipeline/compare_files.h"
#include "volsurf/pipeline/comparison_report.h"
#include "volsurf/pipeline/settings.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string_view>

namespace {

using namespace volsurf;

constexpr const char *kProgram = "volsurf-compare";

/// What CLI11 fills in.
struct Arguments {
  CompareSettings settings;
  std::string frame = "lps";
  std::string json;
  std::vector<std::string> requirements;
  std::optional<double> tolerance_mm;
  bool quiet = false;
};

void add_options(CLI::App &app, Arguments &arguments)
{
  CompareSettings &settings = arguments.settings;
  app.add_option("A", settings.a, "A surface (.vtp .stl .ply .obj) or a label volume, of any format of volsurf")
      ->required();
  app.add_option("B", settings.b, "The reference, the same")->required();
  app.add_option("--label", settings.labels, "A value of label volumes that counts; repeatable [all above 0]")
      ->allow_extra_args(false);
  app.add_option("--tolerance", arguments.tolerance_mm,
                 "Distance in mm that agrees, for the surface Dice [one voxel; without labels 1 mm]");
  app.add_option("--spacing", settings.options.spacing_mm,
                 "Voxels in mm for the overlap of two surfaces [1/256 of their extent]");
  app.add_option("--samples", settings.options.samples,
                 "Samples of each surface's area, besides one in each triangle [400000]");
  app.add_option("--frame", arguments.frame, "Frame of surfaces whose file names none: lps or ras [lps]");
  app.add_option("--json", arguments.json, "Write all results as JSON; - for standard output, instead of the table");
  app.add_option("--distance", settings.distance, "Write A with its distance from B at each vertex, .vtp");
  app.add_option("--require", arguments.requirements,
                 "As 'assd<=0.3' or 'dice>=0.95': exit with code 5 where that is not so; repeatable")
      ->allow_extra_args(false);
  app.add_option("--threads", settings.threads, "Threads; 0: all [0]")->check(CLI::Range(0, 1024));
  app.add_flag("-q,--quiet", arguments.quiet, "Print no table and no warnings");
  app.set_version_flag("--version", version_text());
}

[[noreturn]] void refuse(const std::string &option, const std::string &found, const std::string &allowed)
{
  throw UsageError(option + ": found " + found + "; allowed are " + allowed);
}

void check_number(const std::string &option, double value, bool zero_is_allowed)
{
  if (!std::isfinite(value) || value < 0 || (value == 0 && !zero_is_allowed))
    refuse(option, CLI::detail::to_string(value),
           std::string("finite numbers ") + (zero_is_allowed ? "from" : "above") + " 0");
}

void finish(const CLI::App &app, Arguments &arguments)
{
  CompareSettings &settings = arguments.settings;
  if (arguments.tolerance_mm)
    check_number("--tolerance", *arguments.tolerance_mm, true);
  if (app.count("--spacing") > 0)
    check_number("--spacing", settings.options.spacing_mm, false);
  constexpr std::int64_t kMostSamples = 100000000;
  if (settings.options.samples < 1 || settings.options.samples > kMostSamples)
    refuse("--samples", std::to_string(settings.options.samples), "1 to " + std::to_string(kMostSamples));
  if (arguments.frame != "lps" && arguments.frame != "ras")
    refuse("--frame", "\"" + arguments.frame + "\"", "lps, ras");
  settings.frame = arguments.frame == "ras" ? Frame::ras : Frame::lps;
  settings.options.tolerance_mm = arguments.tolerance_mm;
  if (!arguments.json.empty() && arguments.json != "-")
    settings.json = arguments.json;
  for (const std::string &text : arguments.requirements)
    settings.requirements.push_back(parse_requirement(text));
}

void publish(const ComparedFiles &files, const Arguments &arguments)
{
  if (arguments.json == "-")
    print(to_json(files));
  else if (!arguments.quiet)
    print(to_table(files));
}

int run(const Arguments &arguments)
{
  const auto carry_on = [](std::string_view, double) { return !was_interrupted(); };
  const ComparedFiles files =
      compare_files(arguments.settings, carry_on, [&](const ComparedFiles &found) { publish(found, arguments); });
  if (!arguments.quiet)
    for (const auto *warnings : {&files.a.warnings, &files.b.warnings, &files.comparison.warnings})
      for (const std::string &warning : *warnings)
        std::cerr << "volsurf-compare: warning: " << one_line(warning) << '\n';
  int code = kDone;
  for (const Requirement &requirement : arguments.settings.requirements)
    if (!is_met(requirement, files.comparison))
      code = fail(kProgram, kOutput, failure_text(requirement, files.comparison));
  return code;
}

int print_early_exit(const CLI::App &app, const CLI::ParseError &error)
{
  std::ostringstream out;
  std::ostringstream err;
  if (app.exit(error, out, err) != 0)
    return fail(kProgram, kUsage, std::string(error.what()) + " (see volsurf-compare --help)");
  print(out.str());
  return kDone;
}

} // namespace

int main(int argc, char **argv)
{
  CLI::App app("Distances and overlap of two surfaces or label volumes; docs/metrics.md defines each number.\n\n"
               "Exit codes: 0 done, 1 unexpected, 2 usage, 3 input, 5 output or a --require that is not met, "
               "130 interrupted.",
               "volsurf-compare");
  Arguments arguments;
  add_options(app, arguments);
  refuse_empty_values(app);
  catch_interrupts();
  ignore_closed_pipes();
  try {
    app.parse(argc, argv);
    finish(app, arguments);
    return run(arguments);
  } catch (const CLI::ParseError &error) {
    return print_early_exit(app, error);
  } catch (...) {
    return fail_of_exception(kProgram);
  }
}
