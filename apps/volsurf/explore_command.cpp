#include "explore_command.h"

#include "program/program.h"
#include "progress_bar.h"

#include "volsurf/views/text.h"

#include <iostream>

namespace volsurf {

namespace {

void print_summary(const Exploration &exploration, const views::ExplorationFiles &files)
{
  for (const std::string &warning : exploration.warnings)
    std::cerr << "volsurf: warning: " << one_line(warning) << '\n';
  for (const auto &file : files.all())
    std::cerr << one_line(file.string()) << ": " << exploration.basins() << " basins, persistence up to "
              << exploration.largest_persistence() << '\n';
}

void print_details(const Exploration &exploration)
{
  std::cerr << "field       " << exploration.pixel_type << " samples, sigma " << exploration.sigma_mm << " mm\n"
            << "merge       " << exploration.basins() << " basins, largest persistence "
            << exploration.largest_persistence() << '\n';
  for (const auto &[stage, seconds] : exploration.seconds)
    std::cerr << "time        " << stage << ' ' << seconds << " s\n";
  std::cerr << "memory      " << static_cast<double>(exploration.peak_memory_bytes) / 1e6 << " MB at most, "
            << exploration.threads << " threads\n";
}

} // namespace

int run_explore_command(const ExploreCommandLine &line)
{
  views::ExplorationOutputs outputs(line.files, line.settings.input);
  Exploration exploration;
  {
    ProgressBar bar(line.verbosity != Verbosity::quiet);
    exploration = explore(line.settings, [&](std::string_view stage, double fraction) {
      bar.show(stage, fraction);
      return !was_interrupted();
    });
  }
  outputs.write(exploration);
  if (!line.files.any())
    print(views::to_text(exploration));
  outputs.commit();
  if (line.verbosity != Verbosity::quiet)
    print_summary(exploration, line.files);
  if (line.verbosity == Verbosity::verbose)
    print_details(exploration);
  return 0;
}

} // namespace volsurf
