#include "volsurf/topology/background.h"

#include "volsurf/core/parallel.h"
#include "volsurf/core/radix_sort.h"

namespace volsurf {

namespace {

constexpr std::int64_t kPlanesPerSlab = 16;
constexpr std::int64_t kBasinsPerSlab = 1 << 16;
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

std::vector<BasinId> basins_at_the_border(const std::vector<std::int64_t> &faces)
{
  const auto count = static_cast<std::int64_t>(faces.size());
  std::vector<std::vector<BasinId>> found(static_cast<std::size_t>(slab_count(count, kBasinsPerSlab)));
  parallel_for_slabs(count, kBasinsPerSlab, [&](const Slab &slab) {
    for (auto basin = static_cast<BasinId>(slab.begin); basin < slab.end; ++basin)
      if (faces[basin] > 0)
        found[static_cast<std::size_t>(slab.index)].push_back(basin);
  });
  std::vector<BasinId> basins;
  for (const auto &of_slab : found)
    basins.insert(basins.end(), of_slab.begin(), of_slab.end());
  return basins;
}

/// Appends all that are above basins with faces.
void append_ancestors(const Hierarchy &hierarchy, std::vector<std::int64_t> &faces, std::vector<BasinId> &basins)
{
  constexpr std::int64_t kAppended = -1;
  const std::size_t given = basins.size();
  for (std::size_t i = 0; i < basins.size(); ++i) {
    const BasinId ancestor = hierarchy.ancestor[basins[i]];
    if (faces[ancestor] != 0)
      continue;
    faces[ancestor] = kAppended;
    basins.push_back(ancestor);
  }
  for (std::size_t i = given; i < basins.size(); ++i)
    faces[basins[i]] = 0;
}

/// Adds to each basin's faces those of all that fell off it: what falls off with it. Returns the ranks of basins that
/// have any, ascending. O(basins at the border and their ancestors): of a large volume few, and a pass over all basins
/// by rank would wait for memory at each.
std::vector<std::uint32_t> add_to_ancestors(const Hierarchy &hierarchy, std::vector<std::int64_t> &faces)
{
  std::vector<std::uint32_t> ranks = basins_at_the_border(faces);
  append_ancestors(hierarchy, faces, ranks);
  for (std::uint32_t &basin_or_rank : ranks)
    basin_or_rank = hierarchy.rank[basin_or_rank];
  radix_sort(ranks, [](std::uint32_t rank) { return rank; });
  for (auto rank = ranks.rbegin(); rank != ranks.rend(); ++rank) {
    const BasinId basin = hierarchy.by_rank[*rank];
    const BasinId ancestor = hierarchy.ancestor[basin];
    if (ancestor != basin)
      faces[ancestor] += faces[basin];
  }
  return ranks;
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
  const std::vector<std::uint32_t> ranks = add_to_ancestors(hierarchy, faces_with_parts);
  BasinId background = hierarchy.by_rank.front();
  std::int64_t faces = faces_with_parts[background];
  for (const std::uint32_t rank : ranks) {
    const BasinId part = hierarchy.by_rank[rank];
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
