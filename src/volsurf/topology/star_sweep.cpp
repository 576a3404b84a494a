#include "volsurf/topology/star_sweep.h"

#include "volsurf/core/parallel.h"
#include "volsurf/topology/newborn.h"
#include "volsurf/topology/saddles.h"
#include "volsurf/topology/star_tables.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace volsurf {

namespace {

/// The planes of I around sample plane z, and the maxima over the cells below and above it.
///
/// Planes of cell maxima have one more row and column than there are samples: octant o of sample (x, y) stands at
/// (x + (o & 1), y + (o >> 1 & 1)), and what lies outside the volume is +infinity, the value of the exterior.
class FieldWindow {
public:
  FieldWindow(const Index3 &samples, const PlaneSource &source)
      : samples_(samples), source_(source), cell_stride_(samples[0] + 1), outside_(padded_plane())
  {
    for (auto &plane : field_)
      plane.resize(static_cast<std::size_t>(samples[0] * samples[1] + 2));
    squares_.fill(outside_);
    cells_.fill(outside_);
  }

  /// Makes ready for plane z, which is the first one or follows the one before.
  void advance_to(std::int64_t z)
  {
    if (z != z_ + 1) {
      if (z > 0)
        load(z - 1);
      load(z);
      if (z > 0)
        make_cells(z - 1);
    }
    if (z + 1 < samples_[2]) {
      load(z + 1);
      make_cells(z);
    }
    z_ = z;
  }

  /// The row of samples at (y + dy, z + dz), or the nearest one in the volume.
  const float *row(std::int64_t y, std::int64_t dy, std::int64_t dz) const
  {
    const std::int64_t row = std::clamp<std::int64_t>(y + dy, 0, samples_[1] - 1);
    const std::int64_t plane = std::clamp<std::int64_t>(z_ + dz, 0, samples_[2] - 1);
    return field_[static_cast<std::size_t>(plane % 3)].data() + 1 + row * samples_[0];
  }

  /// The row of maxima at octants `o` with o >> 1 == `octant_row`.
  const float *cell_row(std::int64_t y, int octant_row) const
  {
    const std::int64_t plane = z_ - 1 + (octant_row >> 1);
    const bool inside = plane >= 0 && plane + 1 < samples_[2];
    const std::vector<float> &maxima = inside ? cells_[static_cast<std::size_t>(plane % 2)] : outside_;
    return maxima.data() + (y + (octant_row & 1)) * cell_stride_;
  }

private:
  std::vector<float> padded_plane() const
  {
    const std::int64_t size = cell_stride_ * (samples_[1] + 1);
    return std::vector<float>(static_cast<std::size_t>(size), std::numeric_limits<float>::infinity());
  }

  void load(std::int64_t z)
  {
    float *const plane = field_[static_cast<std::size_t>(z % 3)].data() + 1;
    source_(z, plane);
    float *const squares = squares_[static_cast<std::size_t>(z % 2)].data();
    for (std::int64_t y = 0; y + 1 < samples_[1]; ++y) {
      const float *const samples = plane + y * samples_[0];
      square_maxima(samples, samples + samples_[0], samples_[0], squares + (y + 1) * cell_stride_ + 1);
    }
  }

  void make_cells(std::int64_t z)
  {
    pairwise_maxima(squares_[0].data(), squares_[1].data(), static_cast<std::int64_t>(outside_.size()),
                    cells_[static_cast<std::size_t>(z % 2)].data());
  }

  Index3 samples_;
  const PlaneSource &source_;
  std::int64_t cell_stride_;
  std::int64_t z_ = -2;
  std::array<std::vector<float>, 3> field_;   // one float of slack at each end, since stars read beyond their rows
  std::array<std::vector<float>, 2> squares_; // maxima over 2 x 2 samples of a plane
  std::array<std::vector<float>, 2> cells_;
  std::vector<float> outside_;
};

/// Sweeps one slab.
class SlabSweep {
public:
  SlabSweep(const Index3 &samples, const PlaneSource &field, Exterior exterior, const BorderRule &border, Step *steps,
            SlabStars &stars)
      : samples_(samples), cells_(Index3{samples[0] - 1, samples[1] - 1, samples[2] - 1}), exterior_(exterior),
        border_(border), tables_(star_tables()), window_(samples, field), steps_(steps), stars_(stars),
        masks_(static_cast<std::size_t>(samples[0]))
  {
  }

  void sweep_plane(std::int64_t z)
  {
    window_.advance_to(z);
    for (std::int64_t y = 0; y < samples_[1]; ++y)
      sweep_row(y, z);
  }

private:
  void sweep_row(std::int64_t y, std::int64_t z)
  {
    StarRows rows{};
    for (int i = 0; i < 9; ++i)
      rows[i] = window_.row(y, i % 3 - 1, i / 3 - 1);
    newborn_masks(rows, samples_[0], masks_.data());
    for (int i = 0; i < 4; ++i)
      cell_rows_[i] = window_.cell_row(y, i);
    values_ = rows[4];

    const CellId first_cell = cells_.id(-1, y - 1, z - 1);
    const unsigned real = border_.real_cells(1, y, z) & border_.real_cells(samples_[0] - 2, y, z);
    visit_border(0, y, z, first_cell);
    if (real == 0xFF)
      for (std::int64_t x = 1; x + 1 < samples_[0]; ++x)
        visit(x, masks_[static_cast<std::size_t>(x)], 0xFF, first_cell + x);
    else
      for (std::int64_t x = 1; x + 1 < samples_[0]; ++x)
        visit_border(x, y, z, first_cell + x);
    visit_border(samples_[0] - 1, y, z, first_cell + samples_[0] - 1);
  }

  void visit_border(std::int64_t x, std::int64_t y, std::int64_t z, CellId cell)
  {
    const unsigned real = border_.real_cells(x, y, z);
    visit(x, border_.complete(masks_[static_cast<std::size_t>(x)], real), real, cell);
  }

  float octant_value(std::int64_t x, int octant) const { return cell_rows_[octant >> 1][x + (octant & 1)]; }

  /// `cell` is octant 0 of the star of sample x of the row.
  void visit(std::int64_t x, NewbornMask mask, unsigned real, CellId cell)
  {
    const unsigned cells = newborn_cells(mask);
    const unsigned faces = newborn_faces(mask);
    const int parts = tables_.joined_parts[faces] + __builtin_popcount(tables_.isolated[faces] & ~cells & 0xFFU);
    if (cells == 0xFF)
      attach_to_root(x, real, cell);
    else if ((cells & real) != 0)
      attach_newborn(x, cells, real, cell);
    if (parts > 1)
      add_saddles(x, cells, faces, parts, real, cell);
  }

  /// v is a maximum: the first cell of its star is a root, and the others are attached to it, one axis at a time.
  void attach_to_root(std::int64_t x, unsigned real, CellId cell)
  {
    const int root = __builtin_ctz(real);
    for (unsigned rest = real & (real - 1); rest != 0; rest &= rest - 1) {
      const int octant = __builtin_ctz(rest);
      steps_[cell_of(cell, octant)] = step_across(octant, __builtin_ctz(static_cast<unsigned>(octant ^ root)));
    }
    const CellId root_cell = cell_of(cell, root);
    steps_[root_cell] = kNoStep;
    stars_.roots.push_back(root_cell);
    stars_.root_values.push_back(values_[x]);
  }

  void attach_newborn(std::int64_t x, unsigned cells, unsigned real, CellId cell)
  {
    for (unsigned rest = cells & real; rest != 0; rest &= rest - 1) {
      const int octant = __builtin_ctz(rest);
      const int axis = first_axis(x, cells, octant);
      first_axis_[octant] = static_cast<std::uint8_t>(axis);
      steps_[cell_of(cell, octant)] = step_to(octant, octant ^ (1 << axis), real);
    }
  }

  /// The axis of the first face in K of a newborn octant: towards its largest neighbour that is not newborn, or, where
  /// there is none, by the table.
  int first_axis(std::int64_t x, unsigned cells, int octant) const
  {
    float best = -std::numeric_limits<float>::infinity();
    int best_axis = -1;
    for (int axis = 0; axis < 3; ++axis) {
      const int neighbour = octant ^ (1 << axis);
      if (cells >> neighbour & 1U)
        continue;
      const float value = octant_value(x, neighbour);
      if (value > best) {
        best = value;
        best_axis = axis;
      }
    }
    return best_axis >= 0 ? best_axis : tables_.deep_axis[cells][octant];
  }

  void add_saddles(std::int64_t x, unsigned cells, unsigned faces, int parts, unsigned real, CellId cell)
  {
    Star star{cells, faces, exterior_ == Exterior::none ? real : 0xFFU, {}, first_axis_};
    for (int octant = 0; octant < kOctants; ++octant)
      star.values[octant] = octant_value(x, octant);
    const SaddleFaces saddles = find_saddle_faces(star, parts);
    for (int i = 0; i < saddles.count; ++i) {
      int from = lower_octant(saddles.faces[i]);
      int to = upper_octant(saddles.faces[i]);
      if (!(real >> from & 1U))
        std::swap(from, to);
      stars_.saddles.push_back(static_cast<FaceCode>(cell_of(cell, from)) << 3 | step_to(from, to, real));
      stars_.saddle_values.push_back(values_[x]);
    }
  }

  static Step step_to(int octant, int neighbour, unsigned real)
  {
    if (!(real >> neighbour & 1U))
      return kToExterior;
    return step_across(octant, __builtin_ctz(static_cast<unsigned>(octant ^ neighbour)));
  }

  CellId cell_of(CellId octant_0, int octant) const
  {
    return octant_0 + (octant & 1) + (octant >> 1 & 1) * cells_.row + (octant >> 2) * cells_.plane;
  }

  Index3 samples_;
  CellGrid cells_;
  Exterior exterior_;
  const BorderRule &border_;
  const StarTables &tables_;
  FieldWindow window_;
  Step *steps_;
  SlabStars &stars_;
  std::vector<NewbornMask> masks_;
  std::array<const float *, 4> cell_rows_{};
  const float *values_ = nullptr;
  std::array<std::uint8_t, kOctants> first_axis_{}; // of the newborn octants of the star at hand
};

} // namespace

StarSweep sweep_stars(const Index3 &samples, const PlaneSource &field, Exterior exterior, std::int64_t planes_per_slab,
                      const Progress &progress)
{
  const CellGrid cells(Index3{samples[0] - 1, samples[1] - 1, samples[2] - 1});
  StarSweep sweep{Buffer<Step>(cells.count()), {}};
  sweep.slabs.resize(static_cast<std::size_t>(slab_count(samples[2], planes_per_slab)));
  const BorderRule border(samples, exterior);
  std::atomic<std::int64_t> planes_done{0};
  parallel_for_slabs(samples[2], planes_per_slab, [&](const Slab &slab) {
    SlabSweep slab_sweep(samples, field, exterior, border, sweep.steps.data(),
                         sweep.slabs[static_cast<std::size_t>(slab.index)]);
    for (std::int64_t z = slab.begin; z < slab.end; ++z) {
      slab_sweep.sweep_plane(z);
      report_progress(progress, "merge", static_cast<double>(++planes_done) / static_cast<double>(samples[2]));
    }
  });
  return sweep;
}

} // namespace volsurf
