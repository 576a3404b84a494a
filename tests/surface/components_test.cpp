#include "volsurf/surface/components.h"

#include "support/grids.h"
#include "support/label_volumes.h"

#include "volsurf/core/error.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>

using namespace volsurf;
using namespace volsurf::support;

namespace {

using Edge = std::array<SampleId, 2>;

std::array<Index3, 4> corners_of(const FacePosition &face)
{
  std::array<Index3, 4> corners{face.corner, face.corner, face.corner, face.corner};
  for (const int i : {1, 2})
    ++corners[i][(face.axis + 1) % 3];
  for (const int i : {2, 3})
    ++corners[i][(face.axis + 2) % 3];
  return corners;
}

SampleId sample_id(const Index3 &samples, const Index3 &p)
{
  return p[0] + samples[0] * (p[1] + samples[1] * p[2]);
}

/// Components as lists of faces, by a search from face to face over shared edges.
std::vector<std::vector<FacePosition>> naive_components(const FaceSet &faces)
{
  std::vector<FacePosition> all;
  std::map<Edge, std::vector<std::size_t>> faces_at;
  faces.for_each(0, faces.samples()[2], [&](FaceIndex index, const FacePosition &face) {
    all.push_back(face);
    const auto corners = corners_of(face);
    for (std::size_t i = 0; i < 4; ++i) {
      Edge edge{sample_id(faces.samples(), corners[i]), sample_id(faces.samples(), corners[(i + 1) % 4])};
      std::sort(edge.begin(), edge.end());
      faces_at[edge].push_back(index);
    }
  });
  std::vector<std::set<std::size_t>> neighbours(all.size());
  for (const auto &[edge, at] : faces_at)
    for (const std::size_t face : at)
      neighbours[face].insert(at.begin(), at.end());
  std::vector<std::vector<FacePosition>> components;
  std::vector<bool> seen(all.size());
  for (std::size_t start = 0; start < all.size(); ++start) {
    std::vector<std::size_t> queue;
    if (!seen[start])
      queue.push_back(start);
    seen[start] = true;
    for (std::size_t next = 0; next < queue.size(); ++next)
      for (const std::size_t neighbour : neighbours[queue[next]])
        if (!seen[neighbour]) {
          seen[neighbour] = true;
          queue.push_back(neighbour);
        }
    if (!queue.empty()) {
      components.emplace_back();
      for (const std::size_t face : queue)
        components.back().push_back(all[face]);
    }
  }
  return components;
}

Vec3 world_of(const Grid &grid, const Index3 &p)
{
  return index_to_world(grid, {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
}

double distance(const Vec3 &a, const Vec3 &b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// By Heron's formula on both halves.
double area_of(const Grid &grid, const FacePosition &face)
{
  std::array<Vec3, 4> p{};
  for (std::size_t i = 0; i < 4; ++i)
    p[i] = world_of(grid, corners_of(face)[i]);
  const double a = distance(p[0], p[1]);
  const double b = distance(p[1], p[2]);
  const double c = distance(p[2], p[0]);
  const double s = (a + b + c) / 2;
  return 2 * std::sqrt(s * (s - a) * (s - b) * (s - c));
}

double radius_of(const Grid &grid, const std::vector<FacePosition> &faces)
{
  std::set<Index3> corners;
  for (const FacePosition &face : faces)
    for (const Index3 &corner : corners_of(face))
      corners.insert(corner);
  Vec3 centroid{};
  for (const Index3 &corner : corners)
    for (int axis = 0; axis < 3; ++axis)
      centroid[axis] += world_of(grid, corner)[axis] / static_cast<double>(corners.size());
  double radius = 0;
  for (const Index3 &corner : corners)
    radius = std::max(radius, distance(world_of(grid, corner), centroid));
  return radius;
}

double size_of(const Grid &grid, const std::vector<FacePosition> &faces, RankBy rank_by)
{
  if (rank_by == RankBy::faces)
    return static_cast<double>(faces.size());
  if (rank_by == RankBy::radius)
    return radius_of(grid, faces);
  return std::accumulate(faces.begin(), faces.end(), 0.0,
                         [&](double sum, const FacePosition &face) { return sum + area_of(grid, face); });
}

std::int64_t lowest_face(const Index3 &samples, const std::vector<FacePosition> &faces)
{
  std::int64_t lowest = std::numeric_limits<std::int64_t>::max();
  for (const FacePosition &face : faces)
    lowest = std::min(lowest, 3 * sample_id(samples, face.corner) + face.axis);
  return lowest;
}

struct Case {
  LabelledCells labels;
  Grid grid;
  FaceSet faces;
};

Case random_case(std::int64_t max_size = 5)
{
  Dice dice(*random_seed());
  LabelledCells labels = random_cells(dice, max_size, 3);
  Grid grid = any_grid(dice);
  grid.size = grid_of(labels.cells.size).size;
  FaceSet faces = find_boundary(labels.cells, all_sides(labels));
  return {std::move(labels), grid, std::move(faces)};
}

} // namespace

RC_GTEST_PROP(Components, AreConnectedOverSharedEdges, ())
{
  const Case c = random_case();
  const Components components = find_components(c.faces, c.grid, {});
  const auto expected = naive_components(c.faces);
  RC_ASSERT(components.count() == expected.size());
  std::set<ComponentId> ids;
  for (const auto &faces : expected) {
    std::set<ComponentId> found;
    for (const FacePosition &face : faces)
      found.insert(components.of_face[c.faces.index_of(face.axis, face.corner[0], face.corner[1], face.corner[2])]);
    RC_ASSERT(found.size() == 1U);
    RC_ASSERT(ids.insert(*found.begin()).second);
    RC_ASSERT(*found.begin() >= 1U && *found.begin() <= components.count());
  }
}

RC_GTEST_PROP(Components, AreRankedBySizeThenByTheirLowestFace, ())
{
  const Case c = random_case();
  const RankBy rank_by = *rc::gen::element(RankBy::faces, RankBy::area, RankBy::radius);
  const Components components = find_components(c.faces, c.grid, {KeepAll{}, rank_by});
  std::vector<std::int64_t> lowest(components.count());
  for (const auto &faces : naive_components(c.faces)) {
    const auto &[x, y, z] = faces.front().corner;
    const ComponentId id = components.of_face[c.faces.index_of(faces.front().axis, x, y, z)];
    lowest[id - 1] = lowest_face(c.faces.samples(), faces);
    const double expected = size_of(c.grid, faces, rank_by);
    RC_ASSERT(std::abs(components.sizes[id - 1] - expected) <= 1e-9 * expected);
  }
  for (std::size_t i = 1; i < lowest.size(); ++i)
    RC_ASSERT(components.sizes[i - 1] > components.sizes[i] ||
              (!(components.sizes[i - 1] < components.sizes[i]) && lowest[i - 1] < lowest[i]));
}

RC_GTEST_PROP(Components, KeptFacesAreThoseOfTheFirstComponents, ())
{
  const Case c = random_case();
  RC_PRE(c.faces.size() > 0);
  const Components components = find_components(c.faces, c.grid, {KeepCount{2}, RankBy::faces});
  RC_ASSERT(components.kept == std::min<std::size_t>(2, components.count()));
  const KeptFaces kept = keep_components(find_boundary(c.labels.cells, all_sides(c.labels)), components);
  c.faces.for_each(0, c.faces.samples()[2], [&](FaceIndex index, const FacePosition &face) {
    const auto &[x, y, z] = face.corner;
    const bool is_kept = components.of_face[index] <= components.kept;
    RC_ASSERT(kept.faces.contains(face.axis, x, y, z) == is_kept);
    if (is_kept)
      RC_ASSERT(kept.component[kept.faces.index_of(face.axis, x, y, z)] == components.of_face[index]);
  });
  RC_ASSERT(kept.component.size() == kept.faces.size());
}

TEST(Components, PercentKeepsTheCeilingAndAtLeastOne)
{
  const LabelledCells labels = label_cells(
      {22, 3, 22}, 2, [](const Index3 &p) { return p[0] % 2 == 0 && p[1] == 1 && p[2] % 2 == 0 ? 1U : 0U; });
  const FaceSet faces = find_boundary(labels.cells, all_sides(labels));
  const Grid grid = grid_of(labels.cells.size);
  ASSERT_EQ(find_components(faces, grid, {}).count(), 121U);
  for (const auto &[percent, expected] :
       std::map<double, std::size_t>{{0.001, 1}, {1, 2}, {5, 7}, {50, 61}, {100, 121}})
    EXPECT_EQ(find_components(faces, grid, {KeepPercent{percent}, RankBy::faces}).kept, expected) << percent;
  EXPECT_EQ(find_components(faces, grid, {KeepCount{1000}, RankBy::faces}).kept, 121U);
}

RC_GTEST_PROP(Components, AreTheSameOverManySlabs, ())
{
  Dice dice(*random_seed());
  const LabelledCells labels = label_cells({2, 2, 70}, 2, [&](const Index3 &) { return dice.one_in(6) ? 1U : 0U; });
  const FaceSet faces = find_boundary(labels.cells, all_sides(labels));
  RC_ASSERT(find_components(faces, grid_of(labels.cells.size), {}).count() == naive_components(faces).size());
}

TEST(ParseKeep, TakesItsThreeForms)
{
  EXPECT_TRUE(std::holds_alternative<KeepAll>(parse_keep("all")));
  EXPECT_EQ(std::get<KeepCount>(parse_keep("3")).count, 3);
  EXPECT_DOUBLE_EQ(std::get<KeepPercent>(parse_keep("5%")).percent, 5);
  EXPECT_DOUBLE_EQ(std::get<KeepPercent>(parse_keep("0.5%")).percent, 0.5);
}

TEST(ParseKeep, RefusesAnythingElse)
{
  for (const char *text :
       {"", "0", "-1", "2.5", "0%", "101%", "-5%", "%", "five", "5 %", "5%%", "nan", "nan%", "inf", "1e30", "all "})
    EXPECT_THROW(parse_keep(text), UsageError) << text;
}
