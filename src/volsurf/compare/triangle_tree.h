// Which triangle of a mesh is nearest to a point.
#pragma once

#include "volsurf/compare/pseudonormals.h"
#include "volsurf/core/grid.h"
#include "volsurf/core/mesh.h"

#include <cstdint>
#include <vector>

namespace volsurf {

/// A place on a triangle, seen from a point.
struct NearestPlace {
  std::size_t triangle = 0;
  Feature feature = Feature::face; ///< of the triangle, that holds the place
  Vec3 offset{0, 0, 0};            ///< from the place to the point, in mm
  double squared = 0;              ///< of the offset's length
};

/// A binary tree of boxes round triangles. vtkStaticCellLocator answers the same question, but clears a flag for every
/// triangle of the mesh at each one: three times as slow at 300,000 triangles, and worse with more.
class TriangleTree {
public:
  /// Keeps a reference to the mesh, which must have a triangle. O(n log n).
  explicit TriangleTree(const Mesh &mesh);

  /// The place of the mesh nearest to a point. A triangle near it, as of the last point asked for, makes it faster.
  /// Safe to call from several threads. About O(log n).
  NearestPlace nearest(const Vec3 &point, std::size_t guess = 0) const;

private:
  struct Node {
    Point low; ///< of the box round its triangles
    Point high;
    std::uint32_t first; ///< its triangles in order_
    std::uint32_t count;
    std::uint32_t right; ///< the second child; the first is the next node. 0: a leaf
  };

  void build(std::uint32_t first, std::uint32_t count, const std::vector<Point> &centroids);
  void search_leaf(const Node &leaf, const Vec3 &point, NearestPlace &best) const;

  const Mesh &mesh_;
  std::vector<std::uint32_t> order_; ///< of triangles, so that each node's are together
  std::vector<Node> nodes_;
};

} // namespace volsurf
