#include "volsurf/topology/background.h"

#include "volsurf/core/parallel.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace volsurf {

namespace {

constexpr std::int64_t kPlanesPerSlab = 16;
constexpr std::int64_t kAhead = 16; ///< rows whose ends are fetched before they are needed

/// Adds up the border faces of basins, as other threads do. Those of neighbours, which are mostly of one basin, at
/// once.
class BorderFaces {
public:
  explicit BorderFaces(std::vector<std::int64_t> &faces) : faces_(faces) {}
  BorderFaces(const BorderFaces &) = delete;
  BorderFaces &operator=(const BorderFaces &) = delete;
  ~BorderFaces() { put_down(); }

  void add(BasinId basin, std::int64_t faces)
  {
    if (basin != basin_) {
      put_down();
      basin_ = basin;
      count_ = 0;
    }
    count_ += faces;
  }

private:
  void put_down() { __atomic_fetch_add(&faces_[basin_], count_, __ATOMIC_RELAXED); }

  std::vector<std::int64_t> &faces_;
  BasinId basin_ = 0;
  std::int64_t count_ = 0;
};

/// Adds to each basin's faces those of all that fell off it: what falls off with it. Returns the basins that have any,
/// by rank. O(basins at the border and their ancestors, times their logarithm): of a large volume few, and a pass over
/// all basins by rank would wait for memory at each.
std::vector<BasinId> add_to_ancestors(const Hierarchy &hierarchy, std::vector<std::int64_t> &faces)
{
  std::vector<std::uint32_t> ranks;
  for (BasinId basin = 0; basin < faces.size(); ++basin)
    if (faces[basin] > 0)
      ranks.push_back(hierarchy.rank[basin]);
  std::priority_queue<std::uint32_t> weakest_first({}, std::move(ranks));
  std::vector<BasinId> basins;
  while (!weakest_first.empty()) {
    const BasinId basin = hierarchy.by_rank[weakest_first.top()];
    weakest_first.pop();
    basins.push_back(basin);
    const BasinId ancestor = hierarchy.ancestor[basin];
    if (ancestor == basin)
      continue;
    if (faces[ancestor] == 0)
      weakest_first.push(hierarchy.rank[ancestor]);
    faces[ancestor] += faces[basin];
  }
  std::reverse(basins.begin(), basins.end());
  return basins;
}

} // namespace

std::vector<std::int64_t> count_border_faces(const CellLabels &cells, std::size_t basins)
{
  const auto &[nx, ny, nz] = cells.size;
  std::vector<std::int64_t> faces(basins);
  parallel_for_slabs(nz, kPlanesPerSlab, [&, nx = nx, ny = ny, nz = nz](const Slab &slab) {
    BorderFaces low_x(faces);
    BorderFaces high_x(faces);
    BorderFaces others(faces);
    for (std::int64_t z = slab.begin; z < slab.end; ++z)
      for (std::int64_t y = 0; y < ny; ++y) {
        const BasinId *const row = cells.basins.data() + (z * ny + y) * nx;
        __builtin_prefetch(row + kAhead * nx);
        low_x.add(row[0], 1);
        high_x.add(row[nx - 1], 1);
        const int row_faces = (z == 0) + (z == nz - 1) + (y == 0) + (y == ny - 1);
        for (std::int64_t x = 0; row_faces > 0 && x < nx; ++x)
          others.add(row[x], row_faces);
      }
  });
  return faces;
}

BasinId find_background(const Hierarchy &hierarchy, std::vector<std::int64_t> border_faces)
{
  auto &faces_with_parts = border_faces;
  const std::vector<BasinId> strongest_first = add_to_ancestors(hierarchy, faces_with_parts);
  BasinId background = hierarchy.by_rank.front();
  std::int64_t faces = faces_with_parts[background];
  for (const BasinId part : strongest_first) {
    if (part == background || hierarchy.ancestor[part] != background)
      continue;
    faces -= faces_with_parts[part];
    if (faces_with_parts[part] > faces) {
      background = part;
      faces = faces_with_parts[part];
    }
  }
  return background;
}

} // namespace volsurf
