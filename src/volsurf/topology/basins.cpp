#include "volsurf/topology/basins.h"

#include "volsurf/core/differences.h"
#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"
#include "volsurf/topology/step_entries.h"

#include <algorithm>
#include <limits>

namespace volsurf {

namespace {

constexpr BasinId kUnknown = 0xFFFFFFFFU;

/// Is it a pointer to a cell before this one? Labels wrap round to places that no slab has.
bool leads_back(BasinId entry, std::int64_t cell)
{
  return (entry ^ kPointerFlag) < static_cast<BasinId>(cell);
}

/// condition ? a : b without a branch: here it would be a die's throw.
BasinId choose(bool condition, BasinId a, BasinId b)
{
  const BasinId mask = 0 - static_cast<BasinId>(condition);
  return b ^ ((a ^ b) & mask);
}

/// A path of steps that leaves its slab. Exits have labels of their own, after those of all basins.
struct Exit {
  CellId target; ///< the first cell outside
  std::int64_t cell_count;
  BasinId basin; ///< known after resolve_exits()
};

/// Cells of a row that have the label of an exit.
struct ExitRun {
  CellId begin;
  std::uint32_t count;
  BasinId exit; ///< its place among those of the slab
};

/// The paths that leave a slab, and the cells that are to get another label for them.
struct SlabExits {
  std::vector<Exit> exits;
  std::vector<ExitRun> runs;
};

/// Replaces the step codes of one slab by labels, in two passes over its cells.
///
/// The forward pass writes, for a step to a later cell, a pointer to it, and for a step to an earlier cell what stands
/// there, a label or a pointer; pointers to cells that have been passed are followed on. So pointers always lead to
/// later cells, and the backward pass finds a label behind each. It goes row by row: roots and the steps out of the
/// slab get their labels, enter_steps() does what no other cell of the row has a part in, and a scan does the rest.
class SlabLabeller {
public:
  SlabLabeller(const CellGrid &cells, CellId begin, CellId end, BasinId exterior, Basins &basins, SlabExits &exits)
      : entries_(basins.labels.data() + begin), begin_(begin), size_(end - begin), row_(cells.row), plane_(cells.plane),
        exterior_(exterior), basins_(basins), exits_(exits), changes_(static_cast<std::size_t>((cells.row + 63) / 64))
  {
  }

  /// Returns the number of cells that belong to the exterior's basin.
  std::int64_t label_slab()
  {
    point_forward();
    read_backward();
    return exterior_cells_;
  }

private:
  void point_forward()
  {
    const auto &roots = basins_.roots;
    const auto last = exterior_ == kUnknown ? roots.end() : roots.end() - 1;
    auto root = std::lower_bound(roots.begin(), last, begin_);
    for (std::int64_t row = 0; row < size_; row += row_) {
      for (; root != last && *root < begin_ + row + row_; ++root)
        entries_[*root - begin_] = static_cast<BasinId>(root - roots.begin());
      if (row < plane_)
        label_exits(row, kToLowerPlane);
      if (row >= size_ - plane_)
        label_exits(row, kToUpperPlane);
      enter_steps({entries_, row, row_, plane_, exterior_});
      scan_row(row);
    }
  }

  void label_exits(std::int64_t row, Step step)
  {
    for (std::int64_t cell = row; cell < row + row_; ++cell)
      if (entries_[cell] == step_code(step))
        entries_[cell] = new_exit(begin_ + cell + (step == kToUpperPlane ? plane_ : -plane_));
  }

  /// The first pointer is followed without a branch, which would often be mispredicted.
  void scan_row(std::int64_t row)
  {
    BasinId left = kUnknown;
    for (std::int64_t cell = row; cell < row + row_; ++cell) {
      BasinId entry = entries_[std::min(entries_[cell] ^ kPointerFlag, static_cast<BasinId>(cell))];
      while (leads_back(entry, cell))
        entry = entries_[entry ^ kPointerFlag];
      left = choose(entry == kToTheLeft, left, entry);
      entries_[cell] = left;
    }
  }

  BasinId new_exit(CellId target)
  {
    exits_.exits.push_back({target, 0, kUnknown});
    const std::size_t label = basins_.roots.size() + exits_.exits.size() - 1;
    if (label >= kPointerFlag)
      throw Error("the volume has too many basins; more than 2147483647 are not allowed");
    return static_cast<BasinId>(label);
  }

  void read_backward()
  {
    for (std::int64_t row = size_ - row_; row >= 0; row -= row_) {
      for (std::int64_t cell = row + row_ - 1; cell >= row; --cell)
        read(cell);
      count_row(row);
    }
  }

  /// Counts runs of cells with the same label at once: a branch at each cell would be mispredicted at each run.
  void count_row(std::int64_t row)
  {
    std::fill(changes_.begin(), changes_.end(), std::uint64_t{0});
    mark_differences(entries_ + row, entries_ + row + 1, row_ - 1, changes_.data());
    std::int64_t begin = row;
    std::int64_t word_begin = row;
    for (std::uint64_t rest : changes_) {
      for (; rest != 0; rest &= rest - 1) {
        const std::int64_t end = word_begin + __builtin_ctzll(rest) + 1;
        count(begin, end - begin);
        begin = end;
      }
      word_begin += 64;
    }
    count(begin, row + row_ - begin);
  }

  /// Labels, without their flag, are negative numbers.
  void read(std::int64_t cell)
  {
    const auto target = static_cast<std::int32_t>(entries_[cell] ^ kPointerFlag);
    entries_[cell] = entries_[std::max(target, static_cast<std::int32_t>(cell))];
  }

  void count(std::int64_t begin, std::int64_t cells)
  {
    const BasinId label = entries_[begin];
    if (label >= basins_.roots.size()) {
      const auto exit = static_cast<BasinId>(label - basins_.roots.size());
      exits_.exits[exit].cell_count += cells;
      exits_.runs.push_back({begin_ + begin, static_cast<std::uint32_t>(cells), exit});
    } else if (label == exterior_) {
      exterior_cells_ += cells;
    } else {
      basins_.cell_counts[label] += cells;
    }
  }

  BasinId *entries_; // of the slab's cells
  CellId begin_;
  std::int64_t size_;
  std::int64_t row_;
  std::int64_t plane_;
  BasinId exterior_;
  Basins &basins_;
  SlabExits &exits_;
  std::vector<std::uint64_t> changes_; // of a row: bit x where cells x and x + 1 have two labels
  std::int64_t exterior_cells_ = 0;
};

Basins collect_roots(const CellGrid &cells, StarSweep &sweep, Exterior exterior)
{
  Basins basins;
  std::size_t count = exterior == Exterior::infinite ? 1 : 0;
  for (const StripStars &strip : sweep.strips)
    for (const std::vector<Root> &roots : strip.roots)
      count += roots.size();
  basins.roots.reserve(count);
  basins.values.reserve(count);
  for (std::int64_t z = 0; z < cells.size[2]; ++z)
    for (StripStars &strip : sweep.strips) {
      std::vector<Root> &roots = strip.roots[static_cast<std::size_t>(z)];
      for (const Root &root : roots) {
        basins.roots.push_back(root.cell);
        basins.values.push_back(root.value);
      }
      roots = {};
    }
  if (exterior == Exterior::infinite) {
    basins.roots.push_back(-1);
    basins.values.push_back(std::numeric_limits<float>::infinity());
  }
  if (basins.roots.size() >= kPointerFlag)
    throw Error("the volume has " + std::to_string(basins.roots.size()) + " basins; at most 2147483647 are allowed");
  basins.cell_counts.resize(basins.roots.size());
  return basins;
}

/// Finds the basin of each exit, which may lead through several slabs.
void resolve_exits(std::vector<SlabExits> &slabs, std::int64_t cells_per_slab, Basins &basins)
{
  std::vector<Exit *> chain;
  for (SlabExits &slab : slabs)
    for (Exit &exit : slab.exits) {
      chain.clear();
      Exit *last = &exit;
      BasinId basin = last->basin;
      while (basin == kUnknown) {
        chain.push_back(last);
        basin = basins.labels[last->target];
        if (basin >= basins.roots.size()) {
          last = &slabs[static_cast<std::size_t>(last->target / cells_per_slab)].exits[basin - basins.roots.size()];
          basin = last->basin;
        }
      }
      for (Exit *const on_chain : chain)
        on_chain->basin = basin;
      basins.cell_counts[basin] += exit.cell_count;
    }
}

void relabel(const SlabExits &slab, Basins &basins)
{
  for (const ExitRun &run : slab.runs)
    std::fill_n(basins.labels.data() + run.begin, run.count, slab.exits[run.exit].basin);
}

/// Cells per slab must leave room for the pointers' flag and the codes of steps.
std::int64_t checked_planes_per_slab(const CellGrid &cells, std::int64_t planes_per_slab)
{
  const std::int64_t most = kMostEntries / cells.plane;
  if (most < 1)
    throw Error("a plane of the volume has " + std::to_string(cells.plane) + " cells; at most " +
                std::to_string(kMostEntries) + " are allowed");
  return std::min(planes_per_slab, most);
}

} // namespace

Basins label_basins(const CellGrid &cells, StarSweep &sweep, Exterior exterior, std::int64_t planes_per_slab)
{
  Basins basins = collect_roots(cells, sweep, exterior);
  basins.labels = std::move(sweep.codes);
  const bool has_exterior = exterior == Exterior::infinite;
  const BasinId exterior_basin = has_exterior ? static_cast<BasinId>(basins.roots.size() - 1) : kUnknown;

  planes_per_slab = checked_planes_per_slab(cells, planes_per_slab);
  const auto slabs = static_cast<std::size_t>(slab_count(cells.size[2], planes_per_slab));
  std::vector<SlabExits> exits(slabs);
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
  parallel_for_slabs(static_cast<std::int64_t>(slabs), 1,
                     [&](const Slab &slab) { relabel(exits[static_cast<std::size_t>(slab.index)], basins); });
  return basins;
}

} // namespace volsurf
