#include "volsurf/topology/star_sweep.h"

#include "volsurf/core/parallel.h"
#include "volsurf/topology/field_window.h"
#include "volsurf/topology/saddles.h"
#include "volsurf/topology/star_tables.h"

#include <atomic>
#include <limits>

namespace volsurf {

namespace {

Index3 cell_size_of(const Index3 &samples)
{
  return {samples[0] - 1, samples[1] - 1, samples[2] - 1};
}

/// The octants of a star at hand.
struct OctantRows {
  std::array<CellRow, 4> rows; ///< of octants 2 * i and 2 * i + 1

  float value(std::int64_t x, int octant) const { return rows[octant >> 1].values[x + (octant & 1)]; }
  CornerCode corner(std::int64_t x, int octant) const { return rows[octant >> 1].corners[x + (octant & 1)]; }
};

/// Sweeps one slab.
class SlabSweep {
public:
  SlabSweep(const Index3 &samples, const PlaneSource &field, Exterior exterior, const BorderRule &border,
            BasinId *codes, SlabStars &stars)
      : samples_(samples), cells_(cell_size_of(samples)), exterior_(exterior), border_(border), tables_(star_tables()),
        window_(samples, field, exterior), codes_(codes), stars_(stars), masks_(static_cast<std::size_t>(samples[0]))
  {
  }

  void sweep_plane(std::int64_t z)
  {
    window_.advance_to(z);
    for (std::int64_t y = 0; z < cells_.size[2] && y < cells_.size[1]; ++y)
      find_steps(y, z);
    for (std::int64_t y = 0; y < samples_[1]; ++y)
      find_saddles(y, z);
  }

private:
  void find_steps(std::int64_t y, std::int64_t z)
  {
    const CellRows rows = window_.cell_rows(y);
    BasinId *const codes = codes_ + cells_.id(0, y, z);
    first_steps(rows, cells_.size[0], codes, undecided_);
    if (undecided_.empty())
      return;
    for (int i = 0; i < 4; ++i)
      corner_stars_[static_cast<std::size_t>(i)] = octant_rows(y + (i & 1), z + (i >> 1));
    for (const std::int64_t x : undecided_)
      codes[x] = step_code(step_among_newborn({x, y, z}, rows.centre.corners[x]));
  }

  /// The step of a cell whose neighbours across its first corner v are all newborn at v: by the table, or, where v is a
  /// maximum, towards the first cell of its star, which is the root of a basin.
  Step step_among_newborn(const Index3 &cell, CornerCode corner)
  {
    Index3 v = cell;
    for (int axis = 0; axis < 3; ++axis)
      v[axis] += corner >> axis & 1;
    const int octant = static_cast<int>(corner ^ 7);
    const OctantRows &star = corner_stars_[corner >> 1];
    const unsigned real = border_.real_cells(v[0], v[1], v[2]);
    const unsigned newborn = newborn_cells_of(star, v[0], real);
    if (newborn != 0xFF)
      return step_across(octant, tables_.deep_axis[newborn][octant]);
    const int root = __builtin_ctz(real);
    if (octant != root)
      return step_across(octant, __builtin_ctz(static_cast<unsigned>(octant ^ root)));
    stars_.roots.push_back(cells_.id(cell[0], cell[1], cell[2]));
    stars_.root_values.push_back(star.value(v[0], octant));
    return kNoStep;
  }

  /// Cells outside the volume are none of the exterior node's, so they count as newborn (see BorderRule).
  static unsigned newborn_cells_of(const OctantRows &star, std::int64_t x, unsigned real)
  {
    unsigned newborn = ~real & 0xFFU;
    for (int octant = 0; octant < kOctants; ++octant)
      newborn |= static_cast<unsigned>(star.corner(x, octant) == static_cast<CornerCode>(octant ^ 7)) << octant;
    return newborn;
  }

  OctantRows octant_rows(std::int64_t y, std::int64_t z) const
  {
    return {{window_.octant_row(y, z, 0), window_.octant_row(y, z, 1), window_.octant_row(y, z, 2),
             window_.octant_row(y, z, 3)}};
  }

  void find_saddles(std::int64_t y, std::int64_t z)
  {
    const StarRows rows = window_.star_rows(y);
    newborn_masks(rows, samples_[0], masks_.data());
    complete_border(y, z);
    const OctantRows stars = octant_rows(y, z);
    const std::int64_t count = samples_[0];
    for (std::int64_t x = 0; x < count; ++x) {
      const NewbornMask mask = masks_[static_cast<std::size_t>(x)];
      const int parts = tables_.parts_outside(newborn_cells(mask), newborn_faces(mask));
      if (parts > 1)
        add_saddles({x, y, z}, stars, mask, parts, rows[4][x]);
    }
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

  void add_saddles(const Index3 &v, const OctantRows &rows, NewbornMask mask, int parts, float value)
  {
    const unsigned real = border_.real_cells(v[0], v[1], v[2]);
    Star star{newborn_cells(mask), newborn_faces(mask), exterior_ == Exterior::none ? real : 0xFFU, {}, {}};
    for (int octant = 0; octant < kOctants; ++octant)
      star.values[octant] = rows.value(v[0], octant);
    for (unsigned rest = star.cells & real; rest != 0; rest &= rest - 1) {
      const int octant = __builtin_ctz(rest);
      star.first_axis[octant] = first_axis(star, octant);
    }
    const SaddleFaces saddles = find_saddle_faces(star, parts);
    const CellId octant_0 = cells_.id(v[0] - 1, v[1] - 1, v[2] - 1);
    for (int i = 0; i < saddles.count; ++i) {
      stars_.saddles.push_back(code_of(saddles.faces[i], octant_0, real));
      stars_.saddle_values.push_back(value);
    }
  }

  /// The axis of the first face in K of a newborn octant, as first_steps and step_among_newborn decide it.
  std::uint8_t first_axis(const Star &star, int octant) const
  {
    float best = -std::numeric_limits<float>::infinity();
    std::uint8_t best_axis = tables_.deep_axis[star.cells][octant];
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
      const int neighbour = octant ^ (1 << axis);
      if ((star.cells >> neighbour & 1U) == 0 && star.values[neighbour] > best) {
        best = star.values[neighbour];
        best_axis = axis;
      }
    }
    return best_axis;
  }

  FaceCode code_of(int star_face, CellId octant_0, unsigned real) const
  {
    int from = lower_octant(star_face);
    int to = upper_octant(star_face);
    if (!(real >> from & 1U))
      std::swap(from, to);
    const Step step = (real >> to & 1U) ? step_across(from, star_face / 4) : kToExterior;
    const CellId cell = octant_0 + (from & 1) + (from >> 1 & 1) * cells_.row + (from >> 2) * cells_.plane;
    return static_cast<FaceCode>(cell) << 3 | step;
  }

  Index3 samples_;
  CellGrid cells_;
  Exterior exterior_;
  const BorderRule &border_;
  const StarTables &tables_;
  FieldWindow window_;
  BasinId *codes_;
  SlabStars &stars_;
  std::vector<NewbornMask> masks_;           // of a row of samples
  std::vector<std::int64_t> undecided_;      // cells of a row
  std::array<OctantRows, 4> corner_stars_{}; // around the corners of a row of cells, by corner >> 1
};

} // namespace

StarSweep sweep_stars(const Index3 &samples, const PlaneSource &field, Exterior exterior, std::int64_t planes_per_slab,
                      const Progress &progress)
{
  const CellGrid cells(cell_size_of(samples));
  StarSweep sweep{Buffer<BasinId>(cells.count()), {}};
  sweep.slabs.resize(static_cast<std::size_t>(slab_count(samples[2], planes_per_slab)));
  const BorderRule border(samples, exterior);
  std::atomic<std::int64_t> planes_done{0};
  parallel_for_slabs(samples[2], planes_per_slab, [&](const Slab &slab) {
    SlabSweep slab_sweep(samples, field, exterior, border, sweep.codes.data(),
                         sweep.slabs[static_cast<std::size_t>(slab.index)]);
    for (std::int64_t z = slab.begin; z < slab.end; ++z) {
      slab_sweep.sweep_plane(z);
      report_progress(progress, "merge", static_cast<double>(++planes_done) / static_cast<double>(samples[2]));
    }
  });
  return sweep;
}

} // namespace volsurf
