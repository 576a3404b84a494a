#include "volsurf/surface/boundary.h"

#include "volsurf/core/differences.h"
#include "volsurf/core/parallel.h"

#include <algorithm>

namespace volsurf {

namespace {

constexpr std::int64_t kPlanesPerSlab = 16;

/// One plane of the cells' sides with a frame of what lies outside around it.
class SidePlane {
public:
  SidePlane(const CellLabels &cells, const Sides &sides)
      : cells_(&cells), sides_(&sides), stride_(cells.size[0] + 2),
        values_(static_cast<std::size_t>(stride_ * (cells.size[1] + 2)), sides.outside)
  {
  }

  /// Cells of plane z; planes outside the volume are outside throughout.
  void load(std::int64_t z)
  {
    if (z < 0 || z >= cells_->size[2]) {
      std::fill(values_.begin(), values_.end(), sides_->outside);
      return;
    }
    for (std::int64_t y = 0; y < cells_->size[1]; ++y) {
      const BasinId *const basins = cells_->basins.data() + (z * cells_->size[1] + y) * cells_->size[0];
      RegionId *const out = values_.data() + (y + 1) * stride_ + 1;
      for (std::int64_t x = 0; x < cells_->size[0]; ++x)
        out[x] = sides_->of_basin[basins[x]];
    }
  }

  /// The row of cells y, -1 .. size[1], readable from -1 to size[0].
  const RegionId *row(std::int64_t y) const { return values_.data() + (y + 1) * stride_ + 1; }

private:
  const CellLabels *cells_;
  const Sides *sides_;
  std::int64_t stride_;
  std::vector<RegionId> values_;
};

/// The faces with their lowest corner in sample plane z, between the planes of cells below and above it.
void mark_plane(const SidePlane &below, const SidePlane &above, const Index3 &cells, std::int64_t z, FaceSet &faces)
{
  for (std::int64_t y = 0; y <= cells[1]; ++y) {
    const RegionId *const row = above.row(y);
    if (y < cells[1]) {
      mark_differences(below.row(y), row, cells[0], faces.row(2, y, z));
      if (z < cells[2])
        mark_differences(row - 1, row, cells[0] + 1, faces.row(0, y, z));
    }
    if (z < cells[2])
      mark_differences(above.row(y - 1), row, cells[0], faces.row(1, y, z));
  }
}

} // namespace

FaceSet find_boundary(const CellLabels &cells, const Sides &sides)
{
  const Index3 samples{cells.size[0] + 1, cells.size[1] + 1, cells.size[2] + 1};
  FaceSet faces(samples);
  parallel_for_slabs(samples[2], kPlanesPerSlab, [&](const Slab &slab) {
    SidePlane below(cells, sides);
    SidePlane above(cells, sides);
    below.load(slab.begin - 1);
    for (std::int64_t z = slab.begin; z < slab.end; ++z) {
      above.load(z);
      mark_plane(below, above, cells.size, z, faces);
      std::swap(below, above);
    }
  });
  faces.index();
  return faces;
}

} // namespace volsurf
