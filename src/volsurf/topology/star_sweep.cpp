#include "volsurf/topology/star_sweep.h"

#include "volsurf/core/error.h"
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

/// Towards the first axis in which two octants differ.
int first_axis_between(int octant, int other)
{
  return octant == other ? 0 : __builtin_ctz(static_cast<unsigned>(octant ^ other));
}

constexpr std::size_t kMostSaddles = kOctants - 1; // of a star
constexpr unsigned kLowerRow = 0x33;               // the octants below the sample's row
constexpr unsigned kUpperRow = 0xCC;
constexpr unsigned kLowerPlane = 0x0F; // the octants below the sample's plane
constexpr unsigned kUpperPlane = 0xF0;

/// Sweeps one tile: the samples of some rows in some planes and the cells above them.
class TileSweep {
public:
  TileSweep(const Index3 &samples, const RowRange &rows, const PlaneSource &field, Exterior exterior,
            const BorderRule &border, BasinId *codes, StripStars &stars)
      : samples_(samples), cells_(cell_size_of(samples)), rows_(rows), exterior_(exterior), border_(border),
        tables_(star_tables()), window_(border, rows, field, exterior), codes_(codes), stars_(stars),
        faces_(cells_, rows, 0), deep_(samples[0]), meeting_(samples[0]),
        saddle_faces_(static_cast<std::size_t>(samples[0]))
  {
  }

  void sweep_plane(std::int64_t z, const Slab &planes)
  {
    window_.advance_to(z);
    for (std::int64_t y = rows_.begin; z < cells_.size[2] && y < std::min(rows_.end, cells_.size[1]); ++y)
      first_steps(window_.cell_rows(y), window_.corner_rows(y), cells_.size[0], codes_ + cells_.id(0, y, z));
    sweep_samples(z, z == planes.begin && z > 0 ? kUpperPlane : kAllOctants);
    stars_.saddles[static_cast<std::size_t>(z)] = {saddles_.data(), saddles_.data() + saddle_count_};
    if (z + 1 == planes.end && planes.end < samples_[2])
      sweep_samples(planes.end, kLowerPlane);
  }

private:
  /// Of the stars of plane z, the octants given may be in the tile. Saddles are if the upper ones are.
  void sweep_samples(std::int64_t z, unsigned octants)
  {
    roots_.clear();
    saddle_count_ = 0;
    faces_ = StripFaces(cells_, rows_, z);
    for (std::int64_t y = rows_.begin; y < rows_.end; ++y)
      sweep_row(y, z, octants & (y == rows_.begin && y > 0 ? kUpperRow : kAllOctants));
    if (rows_.end < samples_[1])
      sweep_row(rows_.end, z, octants & kLowerRow);
    add_roots(std::max<std::int64_t>(z - 1, 0));
  }

  void sweep_row(std::int64_t y, std::int64_t z, unsigned octants)
  {
    find_patterns(window_.newborn_row(y, z), y, z, border_, deep_, meeting_);
    const float *const values = window_.values(y, z);
    find_deep_steps(y, z, octants, values);
    if ((octants & kUpperRow & kUpperPlane) != 0)
      find_saddles(y, z, values);
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

  /// The steps of the cells whose neighbours across their first corner v are all newborn at v: by the table, or, where
  /// v is a maximum, towards the first cell of its star, which is the root of a basin.
  void find_deep_steps(std::int64_t y, std::int64_t z, unsigned octants, const float *values)
  {
    for (const auto &[x, mask, real] : deep_) {
      const unsigned newborn = newborn_cells(mask);
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
    find_saddle_faces(meeting_, octant_rows(y, z), exterior_, saddle_faces_.data());
    const std::size_t needed = saddle_count_ + kMostSaddles * static_cast<std::size_t>(meeting_.count);
    if (saddles_.size() < needed)
      saddles_.resize(2 * needed);
    const SaddleFaces *faces = saddle_faces_.data();
    for (const StarPattern &star : meeting_)
      add_saddles(*faces++, {star.x, y, z}, star.real_cells, values[star.x]);
  }

  /// Nearly all stars have one or two. The second is written in any case, so that nobody has to foresee which.
  void add_saddles(const SaddleFaces &faces, const Index3 &v, unsigned real, float value)
  {
    Saddle *const saddles = saddles_.data() + saddle_count_;
    const auto add = [&](int i) { saddles[i] = {code_of(faces[i], v, real), value}; };
    add(0);
    add(1);
    for (int i = 2; i < faces.count(); ++i)
      add(i);
    saddle_count_ += static_cast<std::size_t>(faces.count());
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

  FaceCode code_of(int star_face, const Index3 &v, unsigned real) const
  {
    int from = lower_octant(star_face);
    int to = upper_octant(star_face);
    if (!(real >> from & 1U))
      std::swap(from, to);
    const Step step = (real >> to & 1U) ? step_across(from, star_face / 4) : kToExterior;
    return faces_.code(v, from, step);
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
  StripFaces faces_;            // of a plane
  std::vector<Root> roots_;     // of a plane
  std::vector<Saddle> saddles_; // of a plane, and room for more
  std::size_t saddle_count_ = 0;
  PatternList deep_; // of a row of samples
  PatternList meeting_;
  std::vector<SaddleFaces> saddle_faces_; // of those that meet
};

} // namespace

StripFaces::StripFaces(const CellGrid &cells, const RowRange &rows, std::int64_t z)
    : rows_(rows), row_(cells.row), plane_(cells.plane), first_(cells.id(0, rows.begin - 1, z - 1)),
      cells_of_plane_((rows.count() + 1) * cells.row)
{
  constexpr std::int64_t kMostCells = std::int64_t{1} << 29;
  if (2 * cells_of_plane_ >= kMostCells)
    throw Error("a strip of the volume has " + std::to_string(2 * cells_of_plane_) +
                " cells in two planes; fewer than " + std::to_string(kMostCells) + " are allowed");
}

TileSize default_tile_size(const Index3 &samples)
{
  constexpr std::int64_t kSamplesInStrip = std::int64_t{1} << 14; // of a plane: what a tile holds is 14 times as much
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
  for (std::int64_t strip = 0; strip < strips; ++strip)
    sweep.strips.push_back({{strip * tile.rows, std::min((strip + 1) * tile.rows, samples[1])},
                            std::vector<std::vector<Root>>(planes - 1),
                            std::vector<std::vector<Saddle>>(planes)});
  const BorderRule border(samples, exterior);
  std::atomic<std::int64_t> planes_done{0};
  parallel_for_slabs(strips * slab_count(samples[2], tile.planes), 1, [&](const Slab &work) {
    const std::int64_t strip = work.index % strips;
    const std::int64_t slab = work.index / strips;
    StripStars &stars = sweep.strips[static_cast<std::size_t>(strip)];
    const Slab in_planes{slab, slab * tile.planes, std::min((slab + 1) * tile.planes, samples[2])};
    TileSweep tile_sweep(samples, stars.rows, field, exterior, border, sweep.codes.data(), stars);
    for (std::int64_t z = in_planes.begin; z < in_planes.end; ++z) {
      tile_sweep.sweep_plane(z, in_planes);
      report_progress(progress, "merge", static_cast<double>(++planes_done) / static_cast<double>(strips * samples[2]));
    }
  });
  return sweep;
}

} // namespace volsurf
