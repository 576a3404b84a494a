// What the programs that measure have in common: their options, the volume, and the measurement itself.
#pragma once

#include "volsurf/core/timer.h"
#include "volsurf/core/volume.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace volsurf::bench {

struct RunOptions {
  std::filesystem::path file;
  std::optional<double> sigma_mm; ///< not set: the mean spacing
  double delta = 5;
  double iso = 60;
  int threads = 1;
  int repeats = 1;
  std::int64_t crop = 0; ///< > 0: only the middle, of this many samples per axis
  int tile = 1;          ///< this many copies per axis, each the mirror image of its neighbour
};

void add_run_options(CLI::App &app, RunOptions &options);

/// What one computation took and found.
struct Outcome {
  StageSeconds seconds;
  nlohmann::json facts = nlohmann::json::object();
  std::vector<std::uint32_t> region_of_cell; ///< of those that make the same regions as volsurf; may be empty
};

using Compute = std::function<Outcome(const Volume &, const RunOptions &)>;
using Check = std::function<void(const Outcome &, const Volume &, const RunOptions &)>;

/// Reads, crops and tiles the volume, computes as often as is asked for, and prints one JSON object on standard output:
/// the volume, the options, the stages' seconds and the processors' of each repeat, the facts, and the memory of the
/// first repeat. Reading is not part of any figure but `peak_bytes`, which is the whole program's. `check` comes after
/// all measurements.
void measure_and_print(const RunOptions &options, const Compute &compute, const Check &check = {});

/// Parses the command line, runs `body`, and turns exceptions into a line on standard error. Returns the exit code.
int run_program(CLI::App &app, int argc, char **argv, const std::function<void()> &body);

} // namespace volsurf::bench
