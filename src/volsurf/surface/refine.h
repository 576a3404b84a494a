// A finer mesh of the same surface: long edges are halved.
//
// Where slices are further apart than pixels, the faces between samples are long, and a curved wall cannot follow its
// edge with so few points. In: a mesh; out: the same surface, in which each edge longer than the limit has got a point
// in its middle, round by round. Guarantees: an edge that triangles share is halved for all of them, so that what was
// closed stays closed and junctions stay junctions; the parts of a triangle keep its direction and its arrays.
#pragma once

#include "volsurf/core/mesh.h"

namespace volsurf {

/// An edge is halved at most so many times.
constexpr int kMostHalvings = 3;

/// O(triangles * log(long edges)) per halving. Edges stay longer where the points would no longer have ids.
void halve_long_edges(Mesh &mesh, double longest_mm);

} // namespace volsurf
