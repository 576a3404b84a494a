#include "volsurf/surface/rank_components.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace volsurf {

namespace {

struct CountToKeep {
  std::size_t components;

  std::size_t operator()(const KeepAll &) const { return components; }
  std::size_t operator()(const KeepCount &keep) const
  {
    return std::min(components, static_cast<std::size_t>(keep.count));
  }
  std::size_t operator()(const KeepPercent &keep) const
  {
    const double share = std::ceil(keep.percent * static_cast<double>(components) / 100.0);
    return std::clamp<std::size_t>(static_cast<std::size_t>(share), 1, components);
  }
};

} // namespace

Components rank_components(std::vector<ComponentId> of_face, const std::vector<double> &sizes,
                           const std::vector<std::int64_t> &lowest_face, const Keep &keep)
{
  std::vector<ComponentId> order(sizes.size());
  std::iota(order.begin(), order.end(), ComponentId{0});
  std::sort(order.begin(), order.end(), [&](ComponentId a, ComponentId b) {
    return sizes[a] != sizes[b] ? sizes[a] > sizes[b] : lowest_face[a] < lowest_face[b];
  });

  Components components;
  std::vector<ComponentId> rank(sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    rank[order[i]] = static_cast<ComponentId>(i + 1);
    components.sizes.push_back(sizes[order[i]]);
  }
  for (ComponentId &component : of_face)
    component = rank[component];
  components.of_face = std::move(of_face);
  components.kept = std::visit(CountToKeep{sizes.size()}, keep);
  return components;
}

} // namespace volsurf
