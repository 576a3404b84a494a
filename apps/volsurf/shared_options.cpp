#include "shared_options.h"

#include "volsurf/field/median.h"
#include "volsurf/field/oversample.h"

#include <sstream>

namespace volsurf {

namespace {

EarlyExit early_exit_of(const CLI::App &app, const CLI::ParseError &error)
{
  std::ostringstream out;
  std::ostringstream err;
  const int code = app.exit(error, out, err);
  if (code == 0)
    return {kDone, out.str()};
  if (dynamic_cast<const CLI::ConfigError *>(&error) != nullptr)
    return {kUsage, "--config " + app.get_config_ptr()->as<std::string>() +
                        ": a line is not one of the options (see volsurf --help): " + error.what()};
  return {kUsage, std::string(error.what()) + " (see " + app.get_name() + " --help)"};
}

} // namespace

void add_field_options(CLI::App &app, Settings &settings, SharedTexts &texts)
{
  app.add_option("--median", settings.median_voxels,
                 "Replace each sample by the median of (2R+1)^3 first, R in voxels: against impulse noise [0]")
      ->group("Field")
      ->check(CLI::Range(0, kLargestMedian));
  app.add_option("--oversample", settings.oversampling,
                 "Look at the scan on a grid N times as fine, 1 or 2: for folds thinner than two voxels "
                 "[1; without --delta and --sigma 2 where a small scan has such folds]")
      ->group("Field")
      ->check(CLI::Range(1, kLargestOversampling));
  app.add_option("--sigma", settings.field.sigma_mm,
                 "Gaussian for the gradient in mm; 0: central differences [the geometric mean of the spacings, with "
                 "--oversample 2 0.65 of it]")
      ->group("Field");
  app.add_flag("--edge-map", settings.field.edge_map,
               "The input is an edge strength already (a gradient magnitude, a network's boundary map)")
      ->group("Field")
      ->excludes("--sigma");
  app.add_flag("--paper", texts.paper,
               "Exactly the paper: --sigma 0 --exterior infinite, and surfaces on the voxels' faces")
      ->group("Field")
      ->excludes("--median")
      ->excludes("--oversample")
      ->excludes("--sigma")
      ->excludes("--edge-map");
}

void add_exterior_option(CLI::App &app, Settings &settings)
{
  add_word_option<Exterior>(app, "--exterior", settings.exterior,
                            {{"none", Exterior::none}, {"infinite", Exterior::infinite}},
                            "What lies behind the border: none or infinite [none]")
      ->group("Topology")
      ->excludes("--paper");
}

void add_general_options(CLI::App &app, Settings &settings, SharedTexts &texts)
{
  app.add_option("--series", settings.series_uid, "UID of the DICOM series to read, where a folder holds several")
      ->group("General");
  app.add_option("--threads", settings.threads, "Threads; 0: all [0]")->group("General")->check(CLI::Range(0, 1024));
  app.add_option("--max-memory", settings.max_memory_bytes,
                 "Refuse a scan that would need more, as 8G [what is available]")
      ->transform(CLI::AsSizeValue(false))
      ->group("General");
  app.add_flag("-q,--quiet", texts.quiet, "Print errors only")->group("General");
  app.add_flag("-v,--verbose", texts.verbose, "Print what each stage found and took")->group("General")->excludes("-q");
  app.set_version_flag("--version", version_text())->group("General");
}

void finish_shared(const SharedTexts &texts, Settings &settings)
{
  if (!texts.paper)
    return;
  settings.field.sigma_mm = 0;
  settings.exterior = Exterior::infinite;
  settings.snap = false;
}

Verbosity verbosity_of(const SharedTexts &texts)
{
  return texts.quiet ? Verbosity::quiet : texts.verbose ? Verbosity::verbose : Verbosity::normal;
}

std::optional<EarlyExit> parse_arguments(CLI::App &app, int argc, const char *const *argv)
{
  refuse_empty_values(app);
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError &error) {
    return early_exit_of(app, error);
  }
}

} // namespace volsurf
