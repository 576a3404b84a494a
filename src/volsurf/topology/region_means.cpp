#include "volsurf/topology/region_means.h"

#include "volsurf/core/parallel.h"

#include <array>

namespace volsurf {

namespace {

constexpr std::int64_t kSlabs = 8; // as few as keep threads busy: each has sums for all regions

/// Per region a sum, how many numbers are in it, and how many of these are special.
struct Sums {
  explicit Sums(std::size_t regions) : sum(regions), count(regions), special(regions) {}

  void add(RegionId region, double number, bool is_special = false)
  {
    sum[region] += number;
    ++count[region];
    special[region] += is_special ? 1 : 0;
  }

  std::vector<double> sum;
  std::vector<std::int64_t> count;
  std::vector<std::int64_t> special;
};

/// Calls add_plane(z, sums) for all planes of cells, on all threads, and adds up the sums.
template <typename AddPlane> Sums sum_over_planes(std::int64_t planes, std::size_t regions, const AddPlane &add_plane)
{
  const std::int64_t planes_per_slab = (planes + kSlabs - 1) / kSlabs;
  std::vector<Sums> of_slab(static_cast<std::size_t>(slab_count(planes, planes_per_slab)), Sums(0));
  parallel_for_slabs(planes, planes_per_slab, [&](const Slab &slab) {
    Sums sums(regions);
    for (std::int64_t z = slab.begin; z < slab.end; ++z)
      add_plane(z, sums);
    of_slab[static_cast<std::size_t>(slab.index)] = std::move(sums);
  });
  Sums total(regions);
  for (const Sums &sums : of_slab)
    for (std::size_t region = 0; region < regions; ++region) {
      total.sum[region] += sums.sum[region];
      total.count[region] += sums.count[region];
      total.special[region] += sums.special[region];
    }
  return total;
}

/// Adds the intensities of one row of cells; `rows` are those of its corners' samples.
void add_row(const BasinId *basins, std::int64_t count, const std::array<const float *, 4> &rows,
             const std::vector<RegionId> &region_of_basin, Sums &sums)
{
  const auto corners = [&](std::int64_t x) { return rows[0][x] + rows[1][x] + rows[2][x] + rows[3][x]; };
  float low = corners(0);
  for (std::int64_t x = 0; x < count; ++x) {
    const float high = corners(x + 1);
    sums.add(region_of_basin[basins[x]], static_cast<double>(low + high) / 8);
    low = high;
  }
}

} // namespace

std::vector<double> region_means(const CellLabels &cells, const Volume &volume, const Regions &regions)
{
  const auto &[nx, ny, nz] = cells.size;
  const std::int64_t row = volume.grid.size[0];
  const std::int64_t plane = row * volume.grid.size[1];
  const Sums sums = sum_over_planes(nz, regions.count() + 1, [&, nx = nx, ny = ny](std::int64_t z, Sums &part) {
    for (std::int64_t y = 0; y < ny; ++y) {
      const float *const first = volume.samples.data() + row * y + plane * z;
      add_row(cells.basins.data() + nx * (y + ny * z), nx, {first, first + row, first + plane, first + row + plane},
              regions.of_basin, part);
    }
  });
  std::vector<double> means(regions.count() + 1);
  for (RegionId region = 1; region < means.size(); ++region)
    means[region] = sums.sum[region] / static_cast<double>(sums.count[region]);
  return means;
}

Surroundings surroundings_of(const CellLabels &cells, const Regions &regions, const std::vector<double> &means,
                             RegionId one)
{
  const auto &[nx, ny, nz] = cells.size;
  const std::array<std::int64_t, 3> steps{1, nx, nx * ny};
  const Sums sums = sum_over_planes(nz, means.size(), [&, nx = nx, ny = ny](std::int64_t z, Sums &part) {
    const BasinId *cell = cells.basins.data() + nx * ny * z;
    for (std::int64_t y = 0; y < ny; ++y)
      for (std::int64_t x = 0; x < nx; ++x, ++cell) {
        const RegionId region = regions.of_basin[*cell];
        const std::array<bool, 3> has_lower{x > 0, y > 0, z > 0};
        for (int axis = 0; axis < 3; ++axis) {
          const RegionId lower = has_lower[axis] ? regions.of_basin[*(cell - steps[axis])] : region;
          if (lower == region)
            continue;
          part.add(region, means[lower], lower == one);
          part.add(lower, means[region], region == one);
        }
      }
  });
  Surroundings around{means, std::vector<double>(means.size())};
  for (RegionId region = 1; region < means.size(); ++region) {
    const auto faces = static_cast<double>(sums.count[region]);
    if (!(faces > 0))
      continue;
    around.means[region] = sums.sum[region] / faces;
    around.parts[region] = static_cast<double>(sums.special[region]) / faces;
  }
  return around;
}

} // namespace volsurf
