// Which point of the mesh each corner of each face is.
//
// Points are numbered by sample; where the surface is made a manifold, the copies for further sheets follow, then the
// midpoints of pinched edges, two each. Nothing is searched but the few split samples.
#pragma once

#include "volsurf/surface/face_set.h"

#include <functional>
#include <vector>

namespace volsurf {

/// Whether a cell, also one outside the volume, is on the inside of the surface.
using IsInside = std::function<bool(const Index3 &cell)>;

class PointNumbering {
public:
  /// One point per sample that a face of the set has as a corner. With `is_inside`, points are split between the sheets
  /// of the inside (sheets.h), so that the mesh is a 2-manifold: the set must then be the whole of some components of
  /// the boundary of the inside. Keeps a reference to `faces`. Parallel, O(samples / 64 + faces).
  PointNumbering(const FaceSet &faces, const IsInside &is_inside);

  PointId point_count() const { return point_count_; }

  /// The point of `face` at one of its corners.
  PointId corner(const FacePosition &face, const Index3 &corner) const;

  /// The point of `face` in the middle of one of its sides, given by the side's lower sample and its axis, where the
  /// side is pinched; none otherwise.
  bool has_midpoint(const Index3 &sample, int axis) const;
  PointId midpoint(const FacePosition &face, const Index3 &sample, int axis) const;

  /// Calls visit(point, index position) for every point.
  void for_each_point(const std::function<void(PointId, const Vec3 &)> &visit) const;

private:
  /// A sample with several sheets or pinched edges.
  struct Split {
    SampleId sample;
    std::uint8_t inside;                     // pattern of inside octants
    std::array<std::uint8_t, 4> sheet_order; // sheets that are kept, first the one that has the sample's own point
    std::uint8_t sheet_count;
    PointId first_copy; // of the second kept sheet
  };
  struct PinchedEdge {
    SampleId sample;
    int axis;
  };

  void mark_used_samples();
  void find_splits(const IsInside &is_inside);
  void find_pinched_edges();
  const Split *split_at(SampleId sample) const;
  const PinchedEdge *pinched_edge(SampleId sample, int axis) const;
  unsigned star_faces(const Index3 &sample) const;
  SampleId sample_id(const Index3 &p) const;
  Index3 sample_position(SampleId sample) const;
  PointId own_point(const Index3 &p) const;

  const FaceSet &faces_;
  std::int64_t words_per_row_;
  std::vector<std::uint64_t> used_;    // bit per sample
  std::vector<PointId> points_before_; // per word
  std::vector<Split> splits_;          // by sample
  std::vector<PinchedEdge> pinched_;   // by sample, axis
  PointId first_midpoint_ = 0;
  PointId point_count_ = 0;
};

} // namespace volsurf
