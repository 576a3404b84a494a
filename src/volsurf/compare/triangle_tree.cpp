#include "volsurf/compare/triangle_tree.h"

#include "volsurf/core/vec3.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <utility>

namespace volsurf {

namespace {

constexpr std::uint32_t kLeafTriangles = 4;
constexpr std::size_t kDeepest = 64; // more than twice the depth of a tree of 2^32 triangles

/// From the nearest place of a triangle to a point, and which of the triangle's features holds that place.
struct Offset {
  Vec3 vector;
  Feature feature;
};

/// By the Voronoi regions of the triangle's features (C. Ericson, Real-Time Collision Detection, 2005, 5.1.5).
Offset offset_from_triangle(const Vec3 &p, const Vec3 &a, const Vec3 &b, const Vec3 &c)
{
  const Vec3 ab = minus(b, a);
  const Vec3 ac = minus(c, a);
  const Vec3 ap = minus(p, a);
  const Vec3 bp = minus(p, b);
  const Vec3 cp = minus(p, c);
  const double ab_a = dot(ab, ap);
  const double ac_a = dot(ac, ap);
  if (ab_a <= 0 && ac_a <= 0)
    return {ap, Feature::corner0};
  const double ab_b = dot(ab, bp);
  const double ac_b = dot(ac, bp);
  if (ab_b >= 0 && ac_b <= ab_b)
    return {bp, Feature::corner1};
  const double to_c = ab_a * ac_b - ab_b * ac_a; // the weights of the corners, where the place is inside
  if (to_c <= 0 && ab_a >= 0 && ab_b <= 0)
    return {plus(ap, -ab_a / (ab_a - ab_b), ab), Feature::side0};
  const double ab_c = dot(ab, cp);
  const double ac_c = dot(ac, cp);
  if (ac_c >= 0 && ab_c <= ac_c)
    return {cp, Feature::corner2};
  const double to_b = ab_c * ac_a - ab_a * ac_c;
  if (to_b <= 0 && ac_a >= 0 && ac_c <= 0)
    return {plus(ap, -ac_a / (ac_a - ac_c), ac), Feature::side2};
  const double to_a = ab_b * ac_c - ab_c * ac_b;
  if (to_a <= 0 && ac_b - ab_b >= 0 && ab_c - ac_c >= 0)
    return {plus(bp, -(ac_b - ab_b) / ((ac_b - ab_b) + (ab_c - ac_c)), minus(c, b)), Feature::side1};
  const double sum = to_a + to_b + to_c;
  return {plus(plus(ap, -to_b / sum, ab), -to_c / sum, ac), Feature::face};
}

NearestPlace place_on(const Mesh &mesh, std::size_t t, const Vec3 &point)
{
  const Offset offset = offset_from_triangle(point, corner(mesh, t, 0), corner(mesh, t, 1), corner(mesh, t, 2));
  return {t, offset.feature, offset.vector, dot(offset.vector, offset.vector)};
}

/// Squared distance from a point to a box.
double squared_distance(const Vec3 &point, const Point &low, const Point &high)
{
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double outside = std::max({low[axis] - point[axis], point[axis] - high[axis], 0.0});
    squared += outside * outside;
  }
  return squared;
}

std::vector<Point> centroids_of(const Mesh &mesh)
{
  std::vector<Point> centroids(mesh.triangles.size());
  for (std::size_t t = 0; t < centroids.size(); ++t)
    for (int axis = 0; axis < 3; ++axis)
      for (const PointId id : mesh.triangles[t])
        centroids[t][axis] += mesh.points[id][axis] / 3;
  return centroids;
}

void extend(Point &low, Point &high, const Point &point)
{
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = std::min(low[axis], point[axis]);
    high[axis] = std::max(high[axis], point[axis]);
  }
}

int longest_axis(const Point &low, const Point &high)
{
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (high[axis] - low[axis] > high[longest] - low[longest])
      longest = axis;
  return longest;
}

} // namespace

TriangleTree::TriangleTree(const Mesh &mesh) : mesh_(mesh), order_(mesh.triangles.size())
{
  assert(!mesh.triangles.empty());
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.reserve(order_.size());
  build(0, static_cast<std::uint32_t>(order_.size()), centroids_of(mesh));
}

/// Halves the triangles by their centroids along the box's longest side.
void TriangleTree::build(std::uint32_t first, std::uint32_t count, const std::vector<Point> &centroids)
{
  const Point &start = mesh_.points[mesh_.triangles[order_[first]][0]];
  Node node{start, start, first, count, 0};
  for (std::uint32_t i = first; i < first + count; ++i)
    for (const PointId id : mesh_.triangles[order_[i]])
      extend(node.low, node.high, mesh_.points[id]);
  const std::size_t place = nodes_.size();
  nodes_.push_back(node);
  if (count <= kLeafTriangles)
    return;
  const int axis = longest_axis(node.low, node.high);
  const std::uint32_t half = count / 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t s, std::uint32_t t) {
    return centroids[s][axis] != centroids[t][axis] ? centroids[s][axis] < centroids[t][axis] : s < t;
  });
  build(first, half, centroids);
  nodes_[place].right = static_cast<std::uint32_t>(nodes_.size());
  build(first + half, count - half, centroids);
}

void TriangleTree::search_leaf(const Node &leaf, const Vec3 &point, NearestPlace &best) const
{
  for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
    const NearestPlace place = place_on(mesh_, order_[i], point);
    if (place.squared < best.squared)
      best = place;
  }
}

NearestPlace TriangleTree::nearest(const Vec3 &point, std::size_t guess) const
{
  NearestPlace best = place_on(mesh_, guess, point);
  std::array<std::pair<std::uint32_t, double>, kDeepest> waiting; // nodes, and how far their boxes are
  std::size_t count = 0;
  const auto wait = [&](std::uint32_t node) {
    waiting[count++] = {node, squared_distance(point, nodes_[node].low, nodes_[node].high)};
  };
  wait(0);
  while (count > 0) {
    const auto [number, squared] = waiting[--count];
    if (squared >= best.squared)
      continue;
    const Node &node = nodes_[number];
    if (node.right == 0) {
      search_leaf(node, point, best);
      continue;
    }
    wait(number + 1);
    wait(node.right);
    if (waiting[count - 1].second > waiting[count - 2].second) // the nearer one goes first
      std::swap(waiting[count - 1], waiting[count - 2]);
  }
  return best;
}

} // namespace volsurf
