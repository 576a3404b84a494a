#include "support/sample_tree.h"

#include "support/fields.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace volsurf::support {

namespace {

SampleId find(std::vector<SampleId> &parent, SampleId sample)
{
  while (parent[sample] != sample)
    sample = parent[sample] = parent[parent[sample]];
  return sample;
}

std::vector<SampleId> singletons(std::size_t count)
{
  std::vector<SampleId> samples(count);
  std::iota(samples.begin(), samples.end(), SampleId{0});
  return samples;
}

/// The neighbours of each sample. The exterior is one sample more, the last.
std::vector<std::vector<SampleId>> neighbour_lists(const Field &field, Exterior exterior)
{
  std::vector<std::vector<SampleId>> lists(field.values.size() + 1);
  const auto outside = static_cast<SampleId>(field.values.size());
  for_each_sample(field.size, [&](const Index3 &p, SampleId sample) {
    lists[sample] = neighbours_26(field.size, p);
    if (exterior == Exterior::infinite && lists[sample].size() < 26) {
      lists[sample].push_back(outside);
      lists[outside].push_back(sample);
    }
  });
  return lists;
}

} // namespace

std::multiset<float> sample_persistences(const Field &field, Exterior exterior)
{
  const auto neighbours = neighbour_lists(field, exterior);
  std::vector<float> values = field.values;
  values.push_back(std::numeric_limits<float>::infinity());
  std::vector<SampleId> order = singletons(values.size());
  std::stable_sort(order.begin(), order.end(), [&](SampleId a, SampleId b) { return values[a] > values[b]; });

  std::vector<SampleId> parent = singletons(values.size()); // the root of a component is its highest sample
  std::vector<bool> present(values.size());
  std::multiset<float> persistences;
  for (const SampleId sample : order) {
    present[sample] = true;
    for (const SampleId neighbour : neighbours[sample]) {
      if (!present[neighbour])
        continue;
      SampleId elder = find(parent, sample);
      SampleId younger = find(parent, neighbour);
      if (elder == younger)
        continue;
      if (values[younger] > values[elder])
        std::swap(elder, younger);
      if (values[younger] > values[sample])
        persistences.insert(values[younger] - values[sample]);
      parent[younger] = elder;
    }
  }
  return persistences;
}

std::vector<SampleId> superlevel_components(const Field &field, float level)
{
  std::vector<SampleId> parent = singletons(field.values.size());
  for_each_sample(field.size, [&](const Index3 &p, SampleId sample) {
    for (const SampleId neighbour : neighbours_26(field.size, p))
      if (field.values[sample] >= level && field.values[neighbour] >= level) {
        const SampleId a = find(parent, sample);
        const SampleId b = find(parent, neighbour);
        parent[std::max(a, b)] = std::min(a, b);
      }
  });
  std::vector<SampleId> component(parent.size(), -1);
  for (SampleId sample = 0; sample < static_cast<SampleId>(parent.size()); ++sample)
    if (field.values[sample] >= level)
      component[sample] = find(parent, sample);
  return component;
}

} // namespace volsurf::support
