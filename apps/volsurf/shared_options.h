// The options that all commands of volsurf have.
#pragma once

#include "outcomes.h"

#include "volsurf/core/error.h"
#include "volsurf/pipeline/settings.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace volsurf {

/// What CLI11 fills in; the rest goes straight into Settings.
struct SharedTexts {
  bool paper = false;
  bool quiet = false;
  bool verbose = false;
};

/// An option whose values are documented words.
template <typename Value, typename Target>
CLI::Option *add_word_option(CLI::App &app, const std::string &name, Target &value,
                             const std::vector<std::pair<std::string, Value>> &words, const std::string &description)
{
  const auto parse = [name, &value, words](const std::string &text) {
    const auto found = std::find_if(words.begin(), words.end(), [&](const auto &word) { return word.first == text; });
    if (found != words.end()) {
      value = found->second;
      return;
    }
    std::string allowed;
    for (const auto &word : words)
      allowed += (allowed.empty() ? "" : ", ") + word.first;
    throw UsageError(name + ": found \"" + text + "\"; allowed are " + allowed);
  };
  return app.add_option_function<std::string>(name, parse, description);
}

void add_field_options(CLI::App &app, Settings &settings, SharedTexts &texts);

/// Needs the field options to be there.
void add_exterior_option(CLI::App &app, Settings &settings);

void add_general_options(CLI::App &app, Settings &settings, SharedTexts &texts);

void finish_shared(const SharedTexts &texts, Settings &settings);
Verbosity verbosity_of(const SharedTexts &texts);

/// Reads the arguments, where no option may be an empty text. Nothing where the command can go on.
std::optional<EarlyExit> parse_arguments(CLI::App &app, int argc, const char *const *argv);

} // namespace volsurf
