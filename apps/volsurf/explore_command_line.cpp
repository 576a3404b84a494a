#include "explore_command_line.h"

#include "shared_options.h"

namespace volsurf {

namespace {

void add_output_options(CLI::App &app, ExploreCommandLine &line)
{
  app.add_option("--csv", line.files.csv, "Write regions, components, faces and area over delta as a table")
      ->group("Output");
  app.add_option("--png", line.files.png, "Write the charts as a picture")->group("Output");
  app.add_option("--html", line.files.html, "Write a page: charts, tables and what to type next")->group("Output");
  add_word_option<Frame>(app, "--frame", line.settings.frame, {{"lps", Frame::lps}, {"ras", Frame::ras}},
                         "World frame of the points: lps or ras [lps]")
      ->group("Output");
}

} // namespace

bool is_explore_command(int argc, const char *const *argv)
{
  return argc > 1 && std::string(argv[1]) == "explore";
}

ParsedExploreCommandLine parse_explore_command_line(int argc, const char *const *argv)
{
  ParsedExploreCommandLine parsed;
  ExploreCommandLine &line = parsed.command_line;
  SharedTexts texts;
  CLI::App app(
      "What each delta would give on a scan, so that you can choose one: regions, connected surfaces and area\n"
      "over delta, and the strongest regions. Prints tables, or writes the files that are named.",
      "volsurf explore");
  app.add_option("INPUT", line.settings.input, "The scan")->required();
  add_field_options(app, line.settings, texts);
  add_exterior_option(app, line.settings);
  add_output_options(app, line);
  add_general_options(app, line.settings, texts);
  parsed.early_exit = parse_arguments(app, argc, argv);
  if (parsed.early_exit)
    return parsed;
  finish_shared(texts, line.settings);
  line.verbosity = verbosity_of(texts);
  return parsed;
}

} // namespace volsurf
