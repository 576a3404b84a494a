#include "volsurf/topology/region_means.h"

#include "volsurf/core/parallel.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace volsurf {

namespace {

constexpr std::int64_t kSlabs = 8; // as few as keep threads busy: each has sums for all regions

template <typename Number> void add_up(std::vector<Number> &total, const std::vector<Number> &part)
{
  std::transform(part.begin(), part.end(), total.begin(), total.begin(), std::plus<>());
}

/// Per region, what its faces with other regions say.
struct FaceSums {
  explicit FaceSums(std::size_t regions) : means(regions), faces(regions), faces_with_one(regions) {}

  void add(RegionId region, double mean, bool is_one)
  {
    means[region] += mean;
    ++faces[region];
    faces_with_one[region] += is_one ? 1 : 0;
  }

  std::vector<double> means;
  std::vector<std::int64_t> faces;
  std::vector<std::int64_t> faces_with_one;
};

void add_up(FaceSums &total, const FaceSums &part)
{
  add_up(total.means, part.means);
  add_up(total.faces, part.faces);
  add_up(total.faces_with_one, part.faces_with_one);
}

/// Sums per region, 0 at first, to which add_plane(z, sums) has added all planes of cells, on all threads.
template <typename Sums, typename AddPlane>
Sums sum_over_planes(std::int64_t planes, std::size_t regions, const AddPlane &add_plane)
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
    add_up(total, sums);
  return total;
}

/// Adds the intensities of one row of cells; `rows` are those of its corners' samples.
void add_row(const BasinId *basins, std::int64_t count, const std::array<const float *, 4> &rows,
             const std::vector<RegionId> &region_of_basin, std::vector<double> &sums)
{
  const auto corners = [&](std::int64_t x) { return rows[0][x] + rows[1][x] + rows[2][x] + rows[3][x]; };
  float low = corners(0);
  for (std::int64_t x = 0; x < count;) {
    const BasinId basin = basins[x];
    double sum = 0; // of a run of cells, in a register
    for (; x < count && basins[x] == basin; ++x) {
      const float high = corners(x + 1);
      sum += static_cast<double>(low + high);
      low = high;
    }
    sums[region_of_basin[basin]] += sum / 8;
  }
}

} // namespace

std::vector<double> region_means(const CellLabels &cells, const Volume &volume, const Regions &regions)
{
  const auto &[nx, ny, nz] = cells.size;
  const std::int64_t row = volume.grid.size[0];
  const std::int64_t plane = row * volume.grid.size[1];
  auto means = sum_over_planes<std::vector<double>>(
      nz, regions.count() + 1, [&, nx = nx, ny = ny](std::int64_t z, std::vector<double> &sums) {
        for (std::int64_t y = 0; y < ny; ++y) {
          const float *const first = volume.samples.data() + row * y + plane * z;
          add_row(cells.basins.data() + nx * (y + ny * z), nx, {first, first + row, first + plane, first + row + plane},
                  regions.of_basin, sums);
        }
      });
  for (RegionId region = 1; region < means.size(); ++region)
    means[region] /= static_cast<double>(regions.cell_counts[region - 1]);
  return means;
}

Surroundings surroundings_of(const CellLabels &cells, const Regions &regions, const std::vector<double> &means,
                             RegionId one)
{
  const auto &[nx, ny, nz] = cells.size;
  const auto add_faces = [&](const BasinId *row, const BasinId *lower_row, std::int64_t count, FaceSums &sums) {
    for (std::int64_t x = 0; x < count; ++x) {
      const RegionId region = regions.of_basin[row[x]];
      const RegionId lower = regions.of_basin[lower_row[x]];
      if (lower == region)
        continue;
      sums.add(region, means[lower], lower == one);
      sums.add(lower, means[region], region == one);
    }
  };
  const auto sums = sum_over_planes<FaceSums>(nz, means.size(), [&, nx = nx, ny = ny](std::int64_t z, FaceSums &part) {
    for (std::int64_t y = 0; y < ny; ++y) {
      const BasinId *const row = cells.basins.data() + nx * (y + ny * z);
      add_faces(row + 1, row, nx - 1, part);
      if (y > 0)
        add_faces(row, row - nx, nx, part);
      if (z > 0)
        add_faces(row, row - nx * ny, nx, part);
    }
  });
  Surroundings around{means, std::vector<double>(means.size())};
  for (RegionId region = 1; region < means.size(); ++region) {
    const auto faces = static_cast<double>(sums.faces[region]);
    if (!(faces > 0))
      continue;
    around.means[region] = sums.means[region] / faces;
    around.parts[region] = static_cast<double>(sums.faces_with_one[region]) / faces;
  }
  return around;
}

} // namespace volsurf
