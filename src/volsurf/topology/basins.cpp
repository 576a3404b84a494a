#include "volsurf/topology/basins.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"

#include <algorithm>
#include <array>
#include <limits>

namespace volsurf {

namespace {

constexpr BasinId kUnknown = 0xFFFFFFFFU;

/// Marks a label that is the number of a path out of its slab.
constexpr BasinId kExitFlag = 0x80000000U;

bool is_exit(BasinId label)
{
  return (label & kExitFlag) != 0;
}

BasinId exit_label(std::size_t exit)
{
  if (exit >= kFirstStepCode - kExitFlag)
    throw Error("the volume is too large for its slabs; split it");
  return static_cast<BasinId>(exit) | kExitFlag;
}

/// A path of steps that leaves its slab.
struct Exit {
  CellId target; ///< the first cell outside
  std::int64_t cell_count;
  BasinId basin; ///< known after resolve_exits()
};

/// Replaces the step codes of the cells begin .. end-1 by labels.
class SlabLabeller {
public:
  SlabLabeller(const CellGrid &cells, CellId begin, CellId end, BasinId exterior, Basins &basins,
               std::vector<Exit> &exits)
      : labels_(basins.labels.data()), begin_(begin), end_(end), exterior_(exterior), basins_(basins), exits_(exits)
  {
    for (Step step = 0; step < kNoStep; ++step)
      offsets_[step] = cells.offset(step);
  }

  /// Returns the number of cells that belong to the exterior's basin.
  std::int64_t label_slab()
  {
    label_roots();
    for (CellId cell = begin_; cell < end_; ++cell) {
      if (!is_step_code(labels_[cell]))
        continue;
      path_.clear();
      const BasinId label = follow(cell);
      for (const CellId on_path : path_)
        labels_[on_path] = label;
      labels_[cell] = label;
      count(label, 1 + static_cast<std::int64_t>(path_.size()));
    }
    return exterior_cells_;
  }

private:
  void label_roots()
  {
    const auto &roots = basins_.roots;
    const auto last = exterior_ == kUnknown ? roots.end() : roots.end() - 1;
    const auto first = std::lower_bound(roots.begin(), last, begin_);
    for (auto root = first; root != last && *root < end_; ++root) {
      const auto basin = static_cast<BasinId>(root - roots.begin());
      labels_[*root] = basin;
      basins_.cell_counts[basin] = 1;
    }
  }

  /// The label that the steps from `cell` on lead to; collects the cells without one that lie between in path_.
  BasinId follow(CellId cell)
  {
    BasinId code = labels_[cell];
    for (;;) {
      if (code == step_code(kToExterior))
        return exterior_;
      cell += offsets_[step_of(code)];
      if (cell < begin_ || cell >= end_) {
        exits_.push_back({cell, 0, kUnknown});
        return exit_label(exits_.size() - 1);
      }
      code = labels_[cell];
      if (!is_step_code(code))
        return code;
      path_.push_back(cell);
    }
  }

  void count(BasinId label, std::int64_t cells)
  {
    if (is_exit(label))
      exits_[label & ~kExitFlag].cell_count += cells;
    else if (label == exterior_)
      exterior_cells_ += cells;
    else
      basins_.cell_counts[label] += cells;
  }

  BasinId *labels_;
  CellId begin_;
  CellId end_;
  BasinId exterior_;
  Basins &basins_;
  std::vector<Exit> &exits_;
  std::int64_t exterior_cells_ = 0;
  std::array<std::int64_t, kNoStep> offsets_{};
  std::vector<CellId> path_;
};

Basins collect_roots(StarSweep &sweep, Exterior exterior)
{
  Basins basins;
  for (SlabStars &slab : sweep.slabs) {
    basins.roots.insert(basins.roots.end(), slab.roots.begin(), slab.roots.end());
    basins.values.insert(basins.values.end(), slab.root_values.begin(), slab.root_values.end());
    slab.roots = {};
    slab.root_values = {};
  }
  if (exterior == Exterior::infinite) {
    basins.roots.push_back(-1);
    basins.values.push_back(std::numeric_limits<float>::infinity());
  }
  if (basins.roots.size() >= kExitFlag)
    throw Error("the volume has " + std::to_string(basins.roots.size()) + " basins; at most 2147483647 are allowed");
  basins.cell_counts.resize(basins.roots.size());
  return basins;
}

using SlabExits = std::vector<std::vector<Exit>>;

/// Finds the basin of each exit, which may lead through several slabs.
void resolve_exits(SlabExits &exits, std::int64_t cells_per_slab, Basins &basins)
{
  std::vector<Exit *> chain;
  for (auto &slab_exits : exits)
    for (Exit &exit : slab_exits) {
      chain.clear();
      Exit *last = &exit;
      BasinId basin = last->basin;
      while (basin == kUnknown) {
        chain.push_back(last);
        basin = basins.labels[last->target];
        if (is_exit(basin)) {
          last = &exits[static_cast<std::size_t>(last->target / cells_per_slab)][basin & ~kExitFlag];
          basin = last->basin;
        }
      }
      for (Exit *const on_chain : chain)
        on_chain->basin = basin;
      basins.cell_counts[basin] += exit.cell_count;
    }
}

void relabel_exits(const Slab &slab, std::int64_t cells_per_plane, const std::vector<Exit> &exits, BasinId *labels)
{
  for (CellId cell = slab.begin * cells_per_plane; cell < slab.end * cells_per_plane; ++cell)
    if (is_exit(labels[cell]))
      labels[cell] = exits[labels[cell] & ~kExitFlag].basin;
}

} // namespace

Basins label_basins(const CellGrid &cells, StarSweep &sweep, Exterior exterior, std::int64_t planes_per_slab)
{
  Basins basins = collect_roots(sweep, exterior);
  basins.labels = std::move(sweep.codes);
  const bool has_exterior = exterior == Exterior::infinite;
  const BasinId exterior_basin = has_exterior ? static_cast<BasinId>(basins.roots.size() - 1) : kUnknown;

  const auto slabs = static_cast<std::size_t>(slab_count(cells.size[2], planes_per_slab));
  SlabExits exits(slabs);
  std::vector<std::int64_t> exterior_cells(slabs);
  parallel_for_slabs(cells.size[2], planes_per_slab, [&](const Slab &slab) {
    const auto index = static_cast<std::size_t>(slab.index);
    SlabLabeller labeller(cells, slab.begin * cells.plane, slab.end * cells.plane, exterior_basin, basins,
                          exits[index]);
    exterior_cells[index] = labeller.label_slab();
  });
  for (const std::int64_t count : exterior_cells)
    if (has_exterior)
      basins.cell_counts[exterior_basin] += count;

  resolve_exits(exits, planes_per_slab * cells.plane, basins);
  parallel_for_slabs(cells.size[2], planes_per_slab, [&](const Slab &slab) {
    const auto &slab_exits = exits[static_cast<std::size_t>(slab.index)];
    if (!slab_exits.empty())
      relabel_exits(slab, cells.plane, slab_exits, basins.labels.data());
  });
  return basins;
}

std::vector<SaddleEdge> saddle_edges(const CellGrid &cells, const Basins &basins, StarSweep &sweep)
{
  std::vector<std::vector<SaddleEdge>> slab_edges(sweep.slabs.size());
  parallel_for_slabs(static_cast<std::int64_t>(sweep.slabs.size()), 1, [&](const Slab &slab) {
    SlabStars &stars = sweep.slabs[static_cast<std::size_t>(slab.index)];
    auto &edges = slab_edges[static_cast<std::size_t>(slab.index)];
    for (std::size_t i = 0; i < stars.saddles.size(); ++i) {
      const auto cell = static_cast<CellId>(stars.saddles[i] >> 3);
      const auto step = static_cast<Step>(stars.saddles[i] & 7U);
      const BasinId a = basins.labels[cell];
      const BasinId b = step == kToExterior ? static_cast<BasinId>(basins.roots.size() - 1)
                                            : basins.labels[cell + cells.offset(step)];
      if (a != b)
        edges.push_back({stars.saddle_values[i], a, b});
    }
    stars.saddles = {};
    stars.saddle_values = {};
  });

  std::vector<SaddleEdge> all;
  for (auto &edges : slab_edges) {
    all.insert(all.end(), edges.begin(), edges.end());
    edges = {};
  }
  return all;
}

} // namespace volsurf
