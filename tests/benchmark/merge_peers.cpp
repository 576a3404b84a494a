#include "benchmark/peers.h"
#include "benchmark/plain_kruskal.h"
#include "benchmark/volsurf_run.h"

#include "support/gudhi_persistence.h"

namespace volsurf::bench {

namespace {

/// I of all samples.
std::vector<float> whole_field(const Volume &volume, const RunOptions &options)
{
  const EdgeField field(volume, field_options(options));
  const Index3 &size = volume.grid.size;
  std::vector<float> values(volume.samples.size());
  for (std::int64_t z = 0; z < size[2]; ++z)
    field.plane(z, values.data() + z * size[0] * size[1]);
  return values;
}

} // namespace

Outcome run_plain_kruskal(const Volume &volume, const RunOptions &options)
{
  StageTimer timer;
  const std::vector<float> field = whole_field(volume, options);
  timer.lap("gradient");
  PlainRegions regions = plain_kruskal(volume.grid.size, field, static_cast<float>(options.delta));
  timer.lap("merge");
  return {timer.seconds(), {{"regions", regions.count}}, std::move(regions.of_cell)};
}

Outcome run_gudhi(const Volume &volume, const RunOptions &options)
{
  StageTimer timer;
  const support::Field field{volume.grid.size, whole_field(volume, options)};
  timer.lap("gradient");
  const auto persistences = support::gudhi_persistences(field);
  timer.lap("persistence");
  const auto first = persistences.lower_bound(static_cast<float>(options.delta));
  return {timer.seconds(), {{"regions", 1 + std::distance(first, persistences.end())}}, {}};
}

} // namespace volsurf::bench
