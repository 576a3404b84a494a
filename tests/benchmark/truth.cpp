#include "benchmark/truth.h"

#include "volsurf/core/error.h"
#include "volsurf/core/index_forest.h"

#include <algorithm>
#include <functional>
#include <map>
#include <sstream>

namespace volsurf::bench {

namespace {

using SampleMask = std::vector<std::uint8_t>;

SampleMask samples_that(const Volume &volume, const std::function<bool(double)> &holds)
{
  SampleMask mask(volume.samples.size());
  std::transform(volume.samples.begin(), volume.samples.end(), mask.begin(),
                 [&](float sample) { return holds(static_cast<double>(sample)) ? 1 : 0; });
  return mask;
}

/// Calls work(x, y, z, sample) for all samples in order.
template <typename Work> void for_each_sample(const Index3 &size, Work work)
{
  std::uint32_t sample = 0;
  for (std::int64_t z = 0; z < size[2]; ++z)
    for (std::int64_t y = 0; y < size[1]; ++y)
      for (std::int64_t x = 0; x < size[0]; ++x)
        work(Index3{x, y, z}, sample++);
}

/// Connected along the first `axes` axes.
IndexForest connected_parts(const Index3 &size, const SampleMask &mask, std::size_t axes)
{
  const std::array<std::int64_t, 3> stride{1, size[0], size[0] * size[1]};
  IndexForest parts(static_cast<std::uint32_t>(mask.size()));
  for_each_sample(size, [&](const Index3 &at, std::uint32_t sample) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const std::uint32_t before = sample - static_cast<std::uint32_t>(stride[axis]);
      if (mask[sample] && at[axis] > 0 && mask[before])
        parts.join(sample, before);
    }
  });
  return parts;
}

SampleMask without_what_reaches_the_rim_of_slices(const Index3 &size, const SampleMask &outside)
{
  IndexForest parts = connected_parts(size, outside, 2);
  SampleMask at_rim(outside.size()); // of representatives
  for_each_sample(size, [&](const Index3 &at, std::uint32_t sample) {
    if (outside[sample] && (at[0] == 0 || at[0] + 1 == size[0] || at[1] == 0 || at[1] + 1 == size[1]))
      at_rim[parts.find(sample)] = 1;
  });
  SampleMask rest(outside.size());
  for (std::uint32_t sample = 0; sample < rest.size(); ++sample)
    rest[sample] = at_rim[parts.find(sample)] ? 0 : 1;
  return rest;
}

SampleMask largest_part(const Index3 &size, SampleMask mask)
{
  IndexForest parts = connected_parts(size, mask, 3);
  std::vector<std::uint32_t> counts(mask.size());
  for (std::uint32_t sample = 0; sample < mask.size(); ++sample)
    counts[parts.find(sample)] += mask[sample];
  const auto largest = static_cast<std::uint32_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  for (std::uint32_t sample = 0; sample < mask.size(); ++sample)
    mask[sample] = mask[sample] && parts.find(sample) == largest ? 1 : 0;
  return mask;
}

SampleMask true_samples(const Volume &volume, const TruthRule &rule)
{
  const double from = rule.values.front();
  switch (rule.kind) {
  case TruthKind::kValues:
    return samples_that(volume, [&](double value) {
      return std::find(rule.values.begin(), rule.values.end(), value) != rule.values.end();
    });
  case TruthKind::kFilled:
    return without_what_reaches_the_rim_of_slices(volume.grid.size,
                                                  samples_that(volume, [&](double value) { return value < from; }));
  case TruthKind::kLargest:
    return largest_part(volume.grid.size, samples_that(volume, [&](double value) { return value >= from; }));
  case TruthKind::kFrom:
    break;
  }
  return samples_that(volume, [&](double value) { return value >= from; });
}

CellMask cells_of(const Index3 &size, const SampleMask &samples)
{
  CellMask cells;
  for_each_sample(size, [&](const Index3 &at, std::uint32_t sample) {
    if (at[0] + 1 == size[0] || at[1] + 1 == size[1] || at[2] + 1 == size[2])
      return;
    int corners = 0;
    for (const std::int64_t dz : {0, 1})
      for (const std::int64_t dy : {0, 1})
        for (const std::int64_t dx : {0, 1})
          corners += samples[static_cast<std::size_t>(sample + dx + size[0] * (dy + size[1] * dz))];
    cells.push_back(corners >= 4 ? 1 : 0);
  });
  return cells;
}

} // namespace

TruthRule parse_truth(const std::string &text)
{
  static const std::map<std::string, TruthKind> kinds{{"values", TruthKind::kValues},
                                                      {"from", TruthKind::kFrom},
                                                      {"filled", TruthKind::kFilled},
                                                      {"largest", TruthKind::kLargest}};
  const std::size_t colon = std::min(text.find(':'), text.size());
  const auto kind = kinds.find(text.substr(0, colon));
  std::vector<double> values;
  std::istringstream rest(text.substr(std::min(colon + 1, text.size())));
  for (double value = 0; rest >> value; rest.ignore(1, ','))
    values.push_back(value);
  if (kind == kinds.end() || values.empty() || !rest.eof() || (values.size() > 1 && kind->second != TruthKind::kValues))
    throw UsageError("--truth: found \"" + text +
                     "\"; allowed are values:V,..., from:V, filled:V and largest:V with numbers V");
  return {kind->second, values};
}

CellMask find_truth(const Volume &volume, const TruthRule &rule)
{
  return cells_of(volume.grid.size, true_samples(volume, rule));
}

} // namespace volsurf::bench
