#include "volsurf/topology/join_saddles.h"

#include "volsurf/core/parallel.h"
#include "volsurf/core/radix_sort.h"

#include <algorithm>
#include <array>

namespace volsurf {

namespace {

/// Few enough for their edges and basins to stay in the cache while they are sorted and joined.
constexpr std::size_t kFacesInRun = 1U << 18;

/// The same for what is left of runs.
constexpr std::int64_t kPlanesInBlock = 64;

/// Half-open range of planes of samples.
struct PlaneRange {
  std::int64_t begin;
  std::int64_t end;
};

class SaddleJoiner {
public:
  SaddleJoiner(const CellGrid &cells, const Basins &basins, StarSweep &sweep)
      : cells_(cells), basins_(basins), sweep_(sweep), tree_(basins.roots.size())
  {
    for (Step step = 0; step < kNoStep; ++step)
      offsets_[step] = cells.offset(step);
  }

  /// Returns the edges of a block's planes that are left.
  std::vector<SaddleEdge> join_block(const PlaneRange &block)
  {
    std::vector<SaddleEdge> edges;
    std::vector<SaddleEdge> run_edges;
    std::vector<SaddleEdge> second;
    for (PlaneRange run{block.begin, block.begin}; run.begin < block.end; run.begin = run.end) {
      take_run(run, block.end, run_edges);
      join(run, run_edges, second);
      edges.insert(edges.end(), run_edges.begin(), run_edges.end());
    }
    join(block, edges, second);
    return edges;
  }

  BasinTree join_volume(std::vector<SaddleEdge> edges)
  {
    std::vector<SaddleEdge> second;
    join({0, plane_count()}, edges, second);
    return std::move(tree_);
  }

private:
  std::int64_t plane_count() const { return cells_.size[2] + 1; }

  /// Ends a run where it has enough faces and takes its edges in the order K of faces of equal value.
  void take_run(PlaneRange &run, std::int64_t end, std::vector<SaddleEdge> &edges)
  {
    edges.clear();
    for (std::size_t faces = 0; run.end < end && faces < kFacesInRun; ++run.end)
      for (StripStars &strip : sweep_.strips) {
        auto &saddles = strip.saddles[static_cast<std::size_t>(run.end)];
        faces += saddles.size();
        add_edges(saddles, StripFaces(cells_, strip.rows, run.end), edges);
        saddles = {};
      }
  }

  /// Writes each edge and keeps it where it joins two basins, which no branch could foresee.
  void add_edges(const std::vector<Saddle> &saddles, const StripFaces &faces, std::vector<SaddleEdge> &edges) const
  {
    const BasinId *const labels = basins_.labels.data();
    const auto exterior = static_cast<BasinId>(basins_.roots.size() - 1);
    std::size_t count = edges.size();
    edges.resize(count + saddles.size());
    for (const Saddle &saddle : saddles) {
      const CellId cell = faces.cell(saddle.face);
      const Step step = StripFaces::step(saddle.face);
      const BasinId a = labels[cell];
      const BasinId b = step == kToExterior ? exterior : labels[cell + offsets_[step]];
      edges[count] = {saddle.value, a, b};
      count += a != b ? 1 : 0;
    }
    edges.resize(count);
  }

  /// Sorts edges by decreasing value, those of equal value in the order K, and joins what the planes decide.
  void join(const PlaneRange &planes, std::vector<SaddleEdge> &edges, std::vector<SaddleEdge> &second)
  {
    radix_sort(edges, second, [](const SaddleEdge &edge) { return descending_bits(edge.value); });
    join_basins(basins_.values, block_of(planes), edges, tree_);
  }

  /// The basins around the planes: as far from them as they are many. Closed are those that have no cell in the planes
  /// of cells right below and right above, which other samples have in their stars, too.
  BasinBlock block_of(const PlaneRange &planes) const
  {
    const bool is_volume = planes.begin == 0 && planes.end == plane_count();
    if (is_volume)
      return {{0, static_cast<BasinId>(basins_.roots.size())}, std::vector<std::uint8_t>(basins_.roots.size())};
    const std::int64_t margin = planes.end - planes.begin;
    const BasinRange inner{first_basin(planes.begin), first_basin(planes.end - 1)};
    BasinBlock block{{first_basin(planes.begin - margin), first_basin(planes.end - 1 + margin)}, {}};
    block.open.assign(block.basins.count(), 1);
    if (inner.begin < inner.end)
      std::fill_n(block.open.begin() + (inner.begin - block.basins.begin), inner.count(), std::uint8_t{0});
    if (planes.begin > 0)
      open_basins_in(planes.begin - 1, block);
    if (planes.end < plane_count())
      open_basins_in(planes.end - 1, block);
    return block;
  }

  /// The first basin, but the exterior's, with its root in a plane of cells or above.
  BasinId first_basin(std::int64_t plane) const
  {
    const auto &roots = basins_.roots;
    const auto end = roots.end() - (roots.back() < 0 ? 1 : 0);
    return static_cast<BasinId>(std::lower_bound(roots.begin(), end, cells_.id(0, 0, plane)) - roots.begin());
  }

  void open_basins_in(std::int64_t plane, BasinBlock &block) const
  {
    const BasinId *const labels = basins_.labels.data() + cells_.id(0, 0, plane);
    for (std::int64_t i = 0; i < cells_.plane; ++i)
      if (block.basins.contains(labels[i]))
        block.open[labels[i] - block.basins.begin] = 1;
  }

  const CellGrid &cells_;
  const Basins &basins_;
  StarSweep &sweep_;
  BasinTree tree_;
  std::array<std::int64_t, kNoStep> offsets_{}; // of steps
};

} // namespace

BasinTree join_saddles(const CellGrid &cells, const Basins &basins, StarSweep &sweep, std::int64_t planes_per_block)
{
  const std::int64_t planes = cells.size[2] + 1;
  planes_per_block = std::min(planes_per_block, kPlanesInBlock);
  SaddleJoiner joiner(cells, basins, sweep);
  std::vector<std::vector<SaddleEdge>> edges(static_cast<std::size_t>(slab_count(planes, planes_per_block)));
  parallel_for_slabs(planes, planes_per_block, [&](const Slab &block) {
    edges[static_cast<std::size_t>(block.index)] = joiner.join_block({block.begin, block.end});
  });
  std::vector<SaddleEdge> left;
  for (const auto &block_edges : edges)
    left.insert(left.end(), block_edges.begin(), block_edges.end());
  return joiner.join_volume(std::move(left));
}

} // namespace volsurf
