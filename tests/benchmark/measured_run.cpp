#include "benchmark/measured_run.h"

#include "benchmark/memory_meter.h"

#include "volsurf/core/parallel.h"
#include "volsurf/io/read_volume.h"

#include <algorithm>
#include <ctime>
#include <iostream>

namespace volsurf::bench {

namespace {

/// The volume of `size` whose sample p is `volume`'s sample at (source[0][p[0]], source[1][p[1]], source[2][p[2]]).
Volume rearranged(const Volume &volume, const Index3 &size, const std::array<std::vector<std::int64_t>, 3> &source)
{
  Volume result{volume.grid, {}};
  result.grid.size = size;
  result.samples.reserve(static_cast<std::size_t>(result.grid.sample_count()));
  const auto &[nx, ny, nz] = volume.grid.size;
  for (const std::int64_t z : source[2])
    for (const std::int64_t y : source[1]) {
      const float *const row = volume.samples.data() + (z * ny + y) * nx;
      for (const std::int64_t x : source[0])
        result.samples.push_back(row[x]);
    }
  return result;
}

Volume middle_of(const Volume &volume, std::int64_t most)
{
  Index3 size{};
  std::array<std::vector<std::int64_t>, 3> source;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    size[axis] = std::min(most, volume.grid.size[axis]);
    const std::int64_t begin = (volume.grid.size[axis] - size[axis]) / 2;
    for (std::int64_t i = 0; i < size[axis]; ++i)
      source[axis].push_back(begin + i);
  }
  return rearranged(volume, size, source);
}

Volume tiled(const Volume &volume, int copies)
{
  Index3 size{};
  std::array<std::vector<std::int64_t>, 3> source;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t n = volume.grid.size[axis];
    size[axis] = n * copies;
    for (std::int64_t i = 0; i < size[axis]; ++i)
      source[axis].push_back(i / n % 2 == 0 ? i % n : n - 1 - i % n);
  }
  return rearranged(volume, size, source);
}

Volume load(const RunOptions &options)
{
  Volume volume = read_volume(options.file).volume;
  if (options.crop > 0)
    volume = middle_of(volume, options.crop);
  if (options.tile > 1)
    volume = tiled(volume, options.tile);
  return volume;
}

nlohmann::json as_object(const StageSeconds &seconds)
{
  nlohmann::json stages = nlohmann::json::object();
  for (const auto &[stage, time] : seconds)
    stages[stage] = time;
  return stages;
}

} // namespace

void add_run_options(CLI::App &app, RunOptions &options)
{
  app.add_option("FILE", options.file, "The volume, of any format that volsurf reads")->required();
  app.add_option("--sigma", options.sigma_mm, "Gaussian of the gradient in mm (the mean spacing)");
  app.add_option("--delta", options.delta, "Persistence, or depth of watershed basins, per mm")->capture_default_str();
  app.add_option("--iso", options.iso, "Value of iso-surfaces")->capture_default_str();
  app.add_option("--threads", options.threads, "Threads")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--repeat", options.repeats, "Repeats")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--crop", options.crop, "Only the middle, of this many samples per axis; 0: all")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--tile", options.tile, "This many copies per axis, mirrored by turns, made in memory")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void measure_and_print(const RunOptions &options, const Compute &compute, const Check &check)
{
  const ThreadLimit limit(options.threads);
  const Volume volume = load(options);
  nlohmann::json result{{"file", options.file.filename().string()},
                        {"size", volume.grid.size},
                        {"samples", volume.grid.sample_count()},
                        {"sigma_mm", options.sigma_mm.value_or(mean_spacing_mm(volume.grid))},
                        {"delta", options.delta},
                        {"threads", options.threads}};
  reset_peak();
  const std::int64_t before = resident_bytes();
  Outcome outcome;
  for (int repeat = 0; repeat < options.repeats; ++repeat) {
    outcome = {}; // the memory of the last repeat is none of the next one's
    const std::clock_t start = std::clock();
    outcome = compute(volume, options);
    result["cpu_seconds"].push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    result["seconds"].push_back(as_object(outcome.seconds));
    if (repeat > 0)
      continue; // what the allocator has kept counts as memory from then on
    result["bytes_beyond_input"] = peak_resident_bytes() - before;
    result["peak_bytes"] = std::max(peak_memory_bytes(), peak_resident_bytes());
  }
  result["facts"] = outcome.facts;
  if (check)
    check(outcome, volume, options);
  std::cout << result.dump(2) << '\n';
}

int run_program(CLI::App &app, int argc, char **argv, const std::function<void()> &body)
{
  try {
    app.parse(argc, argv);
    body();
    return 0;
  } catch (const CLI::ParseError &error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception &error) {
    std::cerr << app.get_name() << ": " << error.what() << '\n';
    return 1;
  }
}

} // namespace volsurf::bench
