#include "volsurf/topology/star_sweep.h"

#include "volsurf/core/parallel.h"
#include "volsurf/topology/field_window.h"
#include "volsurf/topology/saddles.h"
#include "volsurf/topology/star_tables.h"

#include <algorithm>
#include <atomic>

namespace volsurf {

namespace {

Index3 cell_size_of(const Index3 &samples)
{
  return {samples[0] - 1, samples[1] - 1, samples[2] - 1};
}

/// I of the octants of the stars of a row: octants 2 * i and 2 * i + 1 of sample x are at [i][x] and [i][x + 1].
using OctantRows = std::array<const float *, 4>;

/// Towards the first axis in which two octants differ.
int first_axis_between(int octant, int other)
{
  return octant == other ? 0 : __builtin_ctz(static_cast<unsigned>(octant ^ other));
}

/// Some x of a row, ascending.
struct RowSamples {
  explicit RowSamples(std::int64_t row_size) : found(static_cast<std::size_t>(row_size)) {}

  const std::int64_t *begin() const { return found.data(); }
  const std::int64_t *end() const { return begin() + count; }

  std::vector<std::int64_t> found;
  std::ptrdiff_t count = 0;
};

constexpr unsigned kAllOctants = 0xFF;
constexpr unsigned kLowerRow = 0x33; // the octants below the sample's row
constexpr unsigned kUpperRow = 0xCC;
constexpr unsigned kLowerPlane = 0x0F; // the octants below the sample's plane
constexpr unsigned kUpperPlane = 0xF0;

/// Sweeps one tile: the samples of some rows in some planes and the cells above them.
class TileSweep {
public:
  TileSweep(const Index3 &samples, const RowRange &rows, const PlaneSource &field, Exterior exterior,
            const BorderRule &border, BasinId *codes, StripStars &stars)
      : samples_(samples), cells_(cell_size_of(samples)), rows_(rows), exterior_(exterior), border_(border),
        tables_(star_tables()), window_(samples, rows, field, exterior), codes_(codes), stars_(stars),
        masks_(static_cast<std::size_t>(samples[0])), deep_(samples[0]), meeting_(samples[0])
  {
  }

  void sweep_plane(std::int64_t z, const Slab &planes)
  {
    window_.advance_to(z);
    for (std::int64_t y = rows_.begin; z < cells_.size[2] && y < std::min(rows_.end, cells_.size[1]); ++y)
      first_steps(window_.cell_rows(y), cells_.size[0], codes_ + cells_.id(0, y, z));
    sweep_samples(z, z == planes.begin && z > 0 ? kUpperPlane : kAllOctants);
    stars_.saddles[static_cast<std::size_t>(z)] = saddles_;
    if (z + 1 == planes.end && planes.end < samples_[2])
      sweep_samples(planes.end, kLowerPlane);
  }

private:
  /// Of the stars of plane z, the octants given may be in the tile. Saddles are if the upper ones are.
  void sweep_samples(std::int64_t z, unsigned octants)
  {
    roots_.clear();
    saddles_.clear();
    for (std::int64_t y = rows_.begin; y < rows_.end; ++y)
      sweep_row(y, z, octants & (y == rows_.begin && y > 0 ? kUpperRow : kAllOctants));
    if (rows_.end < samples_[1])
      sweep_row(rows_.end, z, octants & kLowerRow);
    add_roots(std::max<std::int64_t>(z - 1, 0));
  }

  void sweep_row(std::int64_t y, std::int64_t z, unsigned octants)
  {
    const StarRows rows = window_.star_rows(y, z);
    newborn_masks(rows, samples_[0], masks_.data());
    complete_border(y, z);
    find_candidates();
    find_deep_steps(y, z, octants, rows[4]);
    if ((octants & kUpperRow & kUpperPlane) != 0)
      find_saddles(y, z, rows[4]);
  }

  /// Adds the roots of a plane of samples to those in a plane of cells. The first two rows, and planes, of samples have
  /// their roots in the same row, and plane, of cells.
  void add_roots(std::int64_t cell_plane)
  {
    if (roots_.empty())
      return;
    std::vector<Root> &roots = stars_.roots[static_cast<std::size_t>(cell_plane)];
    roots.insert(roots.end(), roots_.begin(), roots_.end());
    const CellId first_sorted = cells_.id(0, cell_plane == 0 ? cells_.size[1] : 1, cell_plane);
    const auto in_disorder =
        std::partition_point(roots.begin(), roots.end(), [&](const Root &root) { return root.cell < first_sorted; });
    std::sort(roots.begin(), in_disorder, [](const Root &a, const Root &b) { return a.cell < b.cell; });
  }

  /// The samples of the row with deep octants, and those at which parts meet that reach outside. Without a branch for
  /// each: they are few, but nowhere foreseeable.
  void find_candidates()
  {
    const StarTables &tables = tables_;
    const NewbornMask *const masks = masks_.data();
    std::int64_t *deep = deep_.found.data();
    std::int64_t *meeting = meeting_.found.data();
    for (std::int64_t x = 0, count = samples_[0]; x < count; ++x) {
      const unsigned cells = newborn_cells(masks[x]);
      const unsigned parts = tables.parts_outside(cells, newborn_faces(masks[x]));
      *deep = x;
      deep += tables.deep[cells] != 0 ? 1 : 0;
      *meeting = x;
      meeting += (parts & (parts - 1)) != 0 ? 1 : 0;
    }
    deep_.count = deep - deep_.begin();
    meeting_.count = meeting - meeting_.begin();
  }

  /// The steps of the cells whose neighbours across their first corner v are all newborn at v: by the table, or, where
  /// v is a maximum, towards the first cell of its star, which is the root of a basin.
  void find_deep_steps(std::int64_t y, std::int64_t z, unsigned octants, const float *values)
  {
    for (const std::int64_t x : deep_) {
      const unsigned newborn = newborn_cells(masks_[static_cast<std::size_t>(x)]);
      const unsigned real = border_.real_cells(x, y, z);
      const int root = __builtin_ctz(real);
      for (unsigned rest = tables_.deep[newborn] & real & octants; rest != 0; rest &= rest - 1) {
        const int octant = __builtin_ctz(rest);
        const CellId cell = octant_cell({x, y, z}, octant);
        const bool is_maximum = newborn == kAllOctants;
        const int axis = is_maximum ? first_axis_between(octant, root) : tables_.deep_axis[newborn][octant];
        const bool is_root = is_maximum && octant == root;
        codes_[cell] = step_code(is_root ? kNoStep : step_across(octant, axis));
        if (is_root)
          roots_.push_back({cell, values[x]});
      }
    }
  }

  void find_saddles(std::int64_t y, std::int64_t z, const float *values)
  {
    const OctantRows stars = octant_rows(y, z);
    for (const std::int64_t x : meeting_)
      add_saddles({x, y, z}, stars, masks_[static_cast<std::size_t>(x)], values[x]);
  }

  OctantRows octant_rows(std::int64_t y, std::int64_t z) const
  {
    return {window_.octant_row(y, z, 0), window_.octant_row(y, z, 1), window_.octant_row(y, z, 2),
            window_.octant_row(y, z, 3)};
  }

  CellId octant_cell(const Index3 &v, int octant) const
  {
    return cells_.id(v[0] - 1 + (octant & 1), v[1] - 1 + (octant >> 1 & 1), v[2] - 1 + (octant >> 2));
  }

  void complete_border(std::int64_t y, std::int64_t z)
  {
    const auto complete = [&](std::int64_t x) {
      NewbornMask &mask = masks_[static_cast<std::size_t>(x)];
      mask = border_.complete(mask, border_.real_cells(x, y, z));
    };
    complete(0);
    complete(samples_[0] - 1);
    if (y == 0 || z == 0 || y == samples_[1] - 1 || z == samples_[2] - 1)
      for (std::int64_t x = 1; x + 1 < samples_[0]; ++x)
        complete(x);
  }

  void add_saddles(const Index3 &v, const OctantRows &rows, NewbornMask mask, float value)
  {
    const unsigned real = border_.real_cells(v[0], v[1], v[2]);
    const Star star{newborn_cells(mask),
                    newborn_faces(mask),
                    exterior_ == Exterior::none ? real : 0xFFU,
                    {rows[0] + v[0], rows[1] + v[0], rows[2] + v[0], rows[3] + v[0]}};
    const SaddleFaces saddles = find_saddle_faces(star, tables_.parts_outside(star.cells, star.faces));
    for (int i = 0; i < saddles.count; ++i)
      saddles_.push_back({code_of(saddles.faces[i], v, real), value});
  }

  FaceCode code_of(int star_face, const Index3 &v, unsigned real) const
  {
    int from = lower_octant(star_face);
    int to = upper_octant(star_face);
    if (!(real >> from & 1U))
      std::swap(from, to);
    const Step step = (real >> to & 1U) ? step_across(from, star_face / 4) : kToExterior;
    return static_cast<FaceCode>(octant_cell(v, from)) << 3 | step;
  }

  Index3 samples_;
  CellGrid cells_;
  RowRange rows_;
  Exterior exterior_;
  const BorderRule &border_;
  const StarTables &tables_;
  FieldWindow window_;
  BasinId *codes_;
  StripStars &stars_;
  std::vector<Root> roots_;        // of a plane
  std::vector<Saddle> saddles_;    // of a plane
  std::vector<NewbornMask> masks_; // of a row of samples
  RowSamples deep_;
  RowSamples meeting_;
};

} // namespace

TileSize default_tile_size(const Index3 &samples)
{
  constexpr std::int64_t kSamplesInStrip = std::int64_t{1} << 14; // of a plane: what a tile holds is 20 times as much
  const std::int64_t strips = slab_count(samples[1], std::max<std::int64_t>(kSamplesInStrip / samples[0], 8));
  return {large_slab(samples[2]), slab_count(samples[1], strips)};
}

StarSweep sweep_stars(const Index3 &samples, const PlaneSource &field, Exterior exterior, const TileSize &tile,
                      const Progress &progress)
{
  const CellGrid cells(cell_size_of(samples));
  const auto planes = static_cast<std::size_t>(samples[2]);
  const std::int64_t strips = slab_count(samples[1], tile.rows);
  StarSweep sweep{Buffer<BasinId>(cells.count()), {}};
  sweep.strips.assign(static_cast<std::size_t>(strips),
                      {std::vector<std::vector<Root>>(planes - 1), std::vector<std::vector<Saddle>>(planes)});
  const BorderRule border(samples, exterior);
  std::atomic<std::int64_t> planes_done{0};
  parallel_for_slabs(strips * slab_count(samples[2], tile.planes), 1, [&](const Slab &work) {
    const std::int64_t strip = work.index % strips;
    const std::int64_t slab = work.index / strips;
    const RowRange rows{strip * tile.rows, std::min((strip + 1) * tile.rows, samples[1])};
    const Slab in_planes{slab, slab * tile.planes, std::min((slab + 1) * tile.planes, samples[2])};
    TileSweep tile_sweep(samples, rows, field, exterior, border, sweep.codes.data(),
                         sweep.strips[static_cast<std::size_t>(strip)]);
    for (std::int64_t z = in_planes.begin; z < in_planes.end; ++z) {
      tile_sweep.sweep_plane(z, in_planes);
      report_progress(progress, "merge", static_cast<double>(++planes_done) / static_cast<double>(strips * samples[2]));
    }
  });
  return sweep;
}

} // namespace volsurf
