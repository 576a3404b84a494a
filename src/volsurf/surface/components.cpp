#include "volsurf/surface/components.h"

#include "volsurf/core/error.h"
#include "volsurf/core/index_forest.h"
#include "volsurf/core/number_text.h"
#include "volsurf/core/parallel.h"
#include "volsurf/surface/edge_walk.h"
#include "volsurf/surface/rank_components.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace volsurf {

namespace {

constexpr std::int64_t kPlanesPerSlab = 32;

/// Slabs touch faces of their own only; the planes between slabs are joined afterwards.
void join_over_edges(const FaceSet &faces, IndexForest &forest)
{
  const auto join_edge = [&](const EdgeFaces &edge) {
    for (const FaceIndex *face = edge.begin() + 1; face < edge.end(); ++face)
      forest.join(face[-1], *face);
  };
  parallel_for_slabs(faces.samples()[2], kPlanesPerSlab, [&](const Slab &slab) {
    EdgeWalk edges(faces, join_edge);
    for (std::int64_t z = slab.begin; z < slab.end; ++z) {
      edges.walk_within(z);
      if (z > slab.begin)
        edges.walk_with_lower(z);
    }
  });
  EdgeWalk edges(faces, join_edge);
  for (std::int64_t z = 0; z < faces.samples()[2]; z += kPlanesPerSlab)
    edges.walk_with_lower(z);
}

std::vector<double> areas(const FaceSet &faces, const Grid &grid, const std::vector<ComponentId> &of_face,
                          std::size_t count)
{
  const std::array<double, 3> area{face_area_mm2(grid, 0), face_area_mm2(grid, 1), face_area_mm2(grid, 2)};
  std::vector<std::array<std::int64_t, 3>> faces_of_axis(count);
  faces.for_each(0, faces.samples()[2],
                 [&](FaceIndex index, const FacePosition &face) { ++faces_of_axis[of_face[index]][face.axis]; });
  std::vector<double> sizes(count);
  std::transform(faces_of_axis.begin(), faces_of_axis.end(), sizes.begin(), [&](const auto &n) {
    return static_cast<double>(n[0]) * area[0] + static_cast<double>(n[1]) * area[1] +
           static_cast<double>(n[2]) * area[2];
  });
  return sizes;
}

/// The distinct components that have a point at a sample.
void components_at(const FaceSet &faces, const std::vector<ComponentId> &of_face, const Index3 &sample,
                   std::vector<ComponentId> &here)
{
  here.clear();
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 0; k < 4; ++k) {
      Index3 p = sample;
      p[(axis + 1) % 3] -= k & 1;
      p[(axis + 2) % 3] -= k >> 1;
      if (faces.contains(axis, p[0], p[1], p[2]))
        here.push_back(of_face[faces.index_of(axis, p[0], p[1], p[2])]);
    }
  std::sort(here.begin(), here.end());
  here.erase(std::unique(here.begin(), here.end()), here.end());
}

/// Calls visit(component, point) once for each point of each component, in the order of samples.
template <typename Visit>
void for_each_point(const FaceSet &faces, const Grid &grid, const std::vector<ComponentId> &of_face, Visit visit)
{
  std::vector<ComponentId> here;
  for (std::int64_t z = 0; z < faces.samples()[2]; ++z)
    for (std::int64_t y = 0; y < faces.samples()[1]; ++y)
      for (std::int64_t x = 0; x < faces.samples()[0]; ++x) {
        components_at(faces, of_face, {x, y, z}, here);
        for (const ComponentId component : here)
          visit(component,
                index_to_world(grid, {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}));
      }
}

std::vector<double> radii(const FaceSet &faces, const Grid &grid, const std::vector<ComponentId> &of_face,
                          std::size_t count)
{
  std::vector<Vec3> centroid(count);
  std::vector<double> points(count);
  for_each_point(faces, grid, of_face, [&](ComponentId component, const Vec3 &point) {
    for (int i = 0; i < 3; ++i)
      centroid[component][i] += point[i];
    ++points[component];
  });
  for (std::size_t component = 0; component < count; ++component)
    for (double &coordinate : centroid[component])
      coordinate /= points[component];

  std::vector<double> radius(count);
  for_each_point(faces, grid, of_face, [&](ComponentId component, const Vec3 &point) {
    const Vec3 &centre = centroid[component];
    const double distance = std::hypot(point[0] - centre[0], point[1] - centre[1], point[2] - centre[2]);
    radius[component] = std::max(radius[component], distance);
  });
  return radius;
}

/// The trees of a forest, numbered from 0 in the order of their lowest index.
struct Trees {
  std::vector<FaceIndex> roots; ///< per tree: its lowest index
  std::vector<std::int64_t> face_counts;
};

Trees number_trees(IndexForest &forest, std::vector<ComponentId> &of_face)
{
  Trees trees;
  for (FaceIndex face = 0; face < of_face.size(); ++face) {
    const FaceIndex root = forest.find(face);
    if (root == face) {
      of_face[face] = static_cast<ComponentId>(trees.roots.size());
      trees.roots.push_back(face);
      trees.face_counts.push_back(0);
    }
    of_face[face] = of_face[root];
    ++trees.face_counts[of_face[root]];
  }
  return trees;
}

/// Per component the lowest face by (sample of its lowest corner, axis). It is in the row of the face with the lowest
/// index, its root, so that rows without roots need no look.
std::vector<std::int64_t> lowest_faces(const FaceSet &faces, const std::vector<ComponentId> &of_face,
                                       const std::vector<FaceIndex> &roots)
{
  std::vector<std::int64_t> lowest(roots.size(), std::numeric_limits<std::int64_t>::max());
  const Index3 &n = faces.samples();
  const auto lower = [&](FaceIndex index, const FacePosition &face) {
    const SampleId corner = (face.corner[2] * n[1] + face.corner[1]) * n[0] + face.corner[0];
    std::int64_t &component_lowest = lowest[of_face[index]];
    component_lowest = std::min(component_lowest, 3 * corner + face.axis);
  };
  auto root = roots.begin();
  for (std::int64_t row = 0; root != roots.end(); ++row) {
    const bool is_last = row + 1 == n[1] * n[2];
    const FaceIndex end = is_last ? faces.size() : faces.faces_before_row((row + 1) % n[1], (row + 1) / n[1]);
    if (*root >= end)
      continue;
    faces.for_each_in_row(row % n[1], row / n[1], lower);
    root = std::lower_bound(root, roots.end(), end);
  }
  return lowest;
}

} // namespace

Keep parse_keep(const std::string &text)
{
  if (text == "all")
    return KeepAll{};
  const auto parsed = parse_number_text(text);
  const double number = parsed ? parsed->number : 0;
  if (parsed && parsed->is_percentage && number > 0 && number <= 100)
    return KeepPercent{number};
  if (parsed && !parsed->is_percentage && number >= 1 && number <= 1e9 && number == std::floor(number))
    return KeepCount{static_cast<std::int64_t>(number)};
  throw UsageError("--keep: found \"" + text +
                   "\"; allowed are all, a count (3) or a percentage above 0 and up to 100 (5%)");
}

Components find_components(const FaceSet &faces, const Grid &grid, const ComponentOptions &options)
{
  IndexForest forest(faces.size());
  join_over_edges(faces, forest);
  std::vector<ComponentId> of_face(faces.size());
  const Trees trees = number_trees(forest, of_face);

  std::vector<double> sizes(trees.face_counts.begin(), trees.face_counts.end());
  if (options.rank_by == RankBy::area)
    sizes = areas(faces, grid, of_face, sizes.size());
  if (options.rank_by == RankBy::radius)
    sizes = radii(faces, grid, of_face, sizes.size());
  const auto lowest = lowest_faces(faces, of_face, trees.roots);
  return rank_components(std::move(of_face), sizes, lowest, options.keep);
}

KeptFaces keep_components(FaceSet faces, const Components &components)
{
  if (components.kept == components.count())
    return {std::move(faces), components.of_face};
  FaceSet kept(faces.samples());
  std::vector<ComponentId> component;
  faces.for_each(0, faces.samples()[2], [&](FaceIndex index, const FacePosition &face) {
    if (components.of_face[index] > components.kept)
      return;
    const auto &[x, y, z] = face.corner;
    kept.row(face.axis, y, z)[x >> 6] |= std::uint64_t{1} << (x & 63);
    component.push_back(components.of_face[index]);
  });
  kept.index();
  return {std::move(kept), std::move(component)};
}

} // namespace volsurf
