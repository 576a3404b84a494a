// The command line of volsurf explore.
#pragma once

#include "outcomes.h"

#include "volsurf/views/exploration_outputs.h"

#include <optional>

namespace volsurf {

struct ExploreCommandLine {
  Settings settings; ///< of which explore() takes what it needs
  views::ExplorationFiles files;
  Verbosity verbosity = Verbosity::normal;
};

/// True where the first argument is the word explore. A scan of that name is ./explore.
bool is_explore_command(int argc, const char *const *argv);

/// Reads the arguments from that word on. Throws UsageError where a value is out of range.
struct ParsedExploreCommandLine {
  ExploreCommandLine command_line;
  std::optional<EarlyExit> early_exit;
};
ParsedExploreCommandLine parse_explore_command_line(int argc, const char *const *argv);

} // namespace volsurf
