#include "volsurf/topology/saddle_edges.h"

#include "volsurf/core/parallel.h"
#include "volsurf/core/radix_sort.h"
#include "volsurf/topology/basin_forest.h"

#include <algorithm>
#include <cstdlib>

namespace volsurf {

namespace {

/// Few enough for their edges and basins to stay in the cache while they are sorted and joined.
constexpr std::size_t kFacesAtATime = 1U << 18;

/// Some saddle faces of a slab, one after the other.
struct FaceRun {
  const SlabStars &stars;
  std::size_t begin;
  std::size_t end;

  CellId cell(std::size_t i) const { return static_cast<CellId>(stars.saddles[i] >> 3); }
  Step step(std::size_t i) const { return static_cast<Step>(stars.saddles[i] & 7U); }
};

std::vector<SaddleEdge> edges_of(const FaceRun &faces, const CellGrid &cells, const Basins &basins)
{
  std::vector<SaddleEdge> edges;
  edges.reserve(faces.end - faces.begin);
  for (std::size_t i = faces.begin; i < faces.end; ++i) {
    const CellId cell = faces.cell(i);
    const Step step = faces.step(i);
    const BasinId a = basins.labels[cell];
    const BasinId b =
        step == kToExterior ? static_cast<BasinId>(basins.roots.size() - 1) : basins.labels[cell + cells.offset(step)];
    if (a != b)
      edges.push_back({faces.stars.saddle_values[i], a, b});
  }
  return edges;
}

/// Half-open range of basins.
struct BasinRange {
  BasinId begin;
  BasinId end;

  bool contains(BasinId basin) const { return basin >= begin && basin < end; }
};

/// The basins with their roots among the cells of the faces, and as many planes before and after them: nearly all that
/// the faces lie between.
BasinRange basins_around(const FaceRun &faces, const Basins &basins)
{
  const CellId first = faces.cell(faces.begin);
  const CellId last = faces.cell(faces.end - 1);
  const CellId margin = std::abs(last - first);
  const auto end = basins.roots.end() - (basins.roots.back() < 0 ? 1 : 0); // the exterior's basin is none of them
  const auto basins_before = [&](CellId cell) {
    return static_cast<BasinId>(std::lower_bound(basins.roots.begin(), end, cell) - basins.roots.begin());
  };
  return {basins_before(std::min(first, last) - margin), basins_before(std::max(first, last) + margin)};
}

/// Removes sorted edges that close a cycle of edges between basins of the range.
void remove_cycles(std::vector<SaddleEdge> &edges, const BasinRange &range)
{
  BasinForest forest(range.end - range.begin);
  const auto closes_cycle = [&](const SaddleEdge &edge) {
    if (!range.contains(edge.a) || !range.contains(edge.b))
      return false;
    const BasinId a = forest.find(edge.a - range.begin);
    const BasinId b = forest.find(edge.b - range.begin);
    forest.join(a, b);
    return a == b;
  };
  edges.erase(std::remove_if(edges.begin(), edges.end(), closes_cycle), edges.end());
}

/// The edges of a slab, sorted within each run of faces.
std::vector<SaddleEdge> edges_of_slab(const SlabStars &stars, const CellGrid &cells, const Basins &basins)
{
  std::vector<SaddleEdge> kept;
  for (std::size_t begin = 0; begin < stars.saddles.size(); begin += kFacesAtATime) {
    const FaceRun faces{stars, begin, std::min(begin + kFacesAtATime, stars.saddles.size())};
    std::vector<SaddleEdge> edges = edges_of(faces, cells, basins);
    sort_edges(edges);
    remove_cycles(edges, basins_around(faces, basins));
    kept.insert(kept.end(), edges.begin(), edges.end());
  }
  return kept;
}

} // namespace

void sort_edges(std::vector<SaddleEdge> &edges)
{
  radix_sort(edges, [](const SaddleEdge &edge) { return descending_bits(edge.value); });
}

std::vector<SaddleEdge> saddle_edges(const CellGrid &cells, const Basins &basins, StarSweep &sweep)
{
  std::vector<std::vector<SaddleEdge>> edges(sweep.slabs.size());
  parallel_for_slabs(static_cast<std::int64_t>(sweep.slabs.size()), 1, [&](const Slab &slab) {
    SlabStars &stars = sweep.slabs[static_cast<std::size_t>(slab.index)];
    edges[static_cast<std::size_t>(slab.index)] = edges_of_slab(stars, cells, basins);
    stars = {};
  });
  std::vector<SaddleEdge> all;
  for (const auto &slab_edges : edges)
    all.insert(all.end(), slab_edges.begin(), slab_edges.end());
  return all;
}

} // namespace volsurf
