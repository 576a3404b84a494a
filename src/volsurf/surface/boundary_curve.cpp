#include "volsurf/surface/boundary_curve.h"

#include "volsurf/core/index_forest.h"
#include "volsurf/core/parallel.h"
#include "volsurf/core/radix_sort.h"
#include "volsurf/surface/boundary.h"
#include "volsurf/surface/edge_walk.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace volsurf {

namespace {

constexpr std::int64_t kPlanesPerSlab = 16;

using PatchId = std::uint32_t;

/// Faces of one rank, connected over shared edges: one thing at every delta.
struct Patch {
  std::uint32_t rank;
  std::array<std::uint32_t, 3> faces_of_axis;
};

/// Two patches that share an edge of the grid; of the rank of the later one.
struct Junction {
  std::uint32_t rank;
  PatchId a;
  PatchId b;
};

/// The ranks of faces by their cells. Neighbouring faces often lie between the same basins, so that a small table of
/// the pairs met last spares most of the ways through the tree.
class FaceRanks {
public:
  FaceRanks(const CellLabels &cells, const BasinRanks &ranks) : cells_(cells), ranks_(ranks), met_(kMetPairs) {}

  std::uint32_t of(const FacePosition &face)
  {
    Index3 lower = face.corner;
    --lower[face.axis];
    BasinId a = basin_at(lower);
    BasinId b = basin_at(face.corner);
    if (a > b)
      std::swap(a, b);
    MetPair &met = met_[(a * 2654435761U ^ b * 2246822519U) >> (32 - kMetBits)];
    if (met.a != a || met.b != b)
      met = {a, b, ranks_.joined_at(a, b)};
    return met.rank;
  }

private:
  static constexpr int kMetBits = 12;
  static constexpr std::size_t kMetPairs = std::size_t{1} << kMetBits;

  /// No pair at first: two basins differ.
  struct MetPair {
    BasinId a = 0;
    BasinId b = 0;
    std::uint32_t rank = 0;
  };

  BasinId basin_at(const Index3 &cell) const
  {
    const Index3 &n = cells_.size;
    for (int axis = 0; axis < 3; ++axis)
      if (cell[axis] < 0 || cell[axis] >= n[axis])
        return ranks_.background;
    return cells_.basins[(cell[2] * n[1] + cell[1]) * n[0] + cell[0]];
  }

  const CellLabels &cells_;
  const BasinRanks &ranks_;
  std::vector<MetPair> met_;
};

/// Keeps those junctions that join two sets when taken by rank, and calls joined(rank) for each: a minimum spanning
/// forest.
template <typename Joined> void span(std::vector<Junction> &junctions, IndexForest &forest, Joined joined)
{
  radix_sort(junctions, [](const Junction &junction) { return junction.rank; });
  const auto closes_a_ring = [&](const Junction &junction) {
    if (!forest.join(junction.a, junction.b))
      return true;
    joined(junction.rank);
    return false;
  };
  auto kept = junctions.begin();
  for (const Junction &junction : junctions)
    if (!closes_a_ring(junction))
      *kept++ = junction;
  junctions.erase(kept, junctions.end());
}

/// The patches of some planes of faces.
struct SlabPatches {
  std::vector<Patch> patches;
  std::vector<Junction> junctions;  // a minimum spanning forest
  std::vector<PatchId> lower_plane; // patch per face of the first plane
  std::vector<PatchId> upper_plane; // and of the last one
};

class SlabContraction {
public:
  SlabContraction(const FaceSet &faces, const Slab &slab)
      : faces_(faces), slab_(slab), first_(faces.faces_before_plane(slab.begin)),
        ranks_(faces.faces_before_plane(slab.end) - first_), forest_(static_cast<std::uint32_t>(ranks_.size()))
  {
  }

  SlabPatches contract(FaceRanks face_ranks)
  {
    faces_.for_each(slab_.begin, slab_.end,
                    [&](FaceIndex index, const FacePosition &face) { ranks_[index - first_] = face_ranks.of(face); });
    join_faces();
    const std::vector<PatchId> patch_of_face = number_patches();
    keep_spanning_junctions(patch_of_face);
    const auto planes_faces = [&](std::int64_t z) {
      return std::vector<PatchId>(patch_of_face.begin() + (faces_.faces_before_plane(z) - first_),
                                  patch_of_face.begin() + (faces_.faces_before_plane(z + 1) - first_));
    };
    result_.lower_plane = planes_faces(slab_.begin);
    result_.upper_plane = planes_faces(slab_.end - 1);
    return std::move(result_);
  }

private:
  /// Any two faces at an edge are connected from the birth of the later one, so it is enough to join each to the
  /// earliest. Two alone lie between the same two basins.
  void join_faces()
  {
    EdgeWalk edges(faces_, [&](const EdgeFaces &edge) {
      if (edge.count == 2) {
        forest_.join(edge.faces[0] - first_, edge.faces[1] - first_);
        return;
      }
      const auto rank = [&](FaceIndex face) { return ranks_[face - first_]; };
      const FaceIndex earliest =
          *std::min_element(edge.begin(), edge.end(), [&](FaceIndex a, FaceIndex b) { return rank(a) < rank(b); });
      for (const FaceIndex face : edge)
        if (rank(face) == rank(earliest))
          forest_.join(earliest - first_, face - first_);
        else
          result_.junctions.push_back({rank(face), earliest - first_, face - first_});
    });
    for (std::int64_t z = slab_.begin; z < slab_.end; ++z) {
      edges.walk_within(z);
      if (z == 0 || z > slab_.begin)
        edges.walk_with_lower(z);
    }
  }

  std::vector<PatchId> number_patches()
  {
    std::vector<PatchId> patch_of_face(ranks_.size());
    faces_.for_each(slab_.begin, slab_.end, [&](FaceIndex index, const FacePosition &face) {
      const FaceIndex here = index - first_;
      const FaceIndex root = forest_.find(here);
      if (root == here) {
        patch_of_face[here] = static_cast<PatchId>(result_.patches.size());
        result_.patches.push_back({ranks_[here], {}});
      }
      patch_of_face[here] = patch_of_face[root];
      ++result_.patches[patch_of_face[here]].faces_of_axis[static_cast<std::size_t>(face.axis)];
    });
    return patch_of_face;
  }

  void keep_spanning_junctions(const std::vector<PatchId> &patch_of_face)
  {
    for (Junction &junction : result_.junctions)
      junction = {junction.rank, patch_of_face[junction.a], patch_of_face[junction.b]};
    IndexForest forest(static_cast<std::uint32_t>(result_.patches.size()));
    span(result_.junctions, forest, [](std::uint32_t) {});
    result_.junctions.shrink_to_fit();
  }

  const FaceSet &faces_;
  const Slab slab_;
  const FaceIndex first_;
  std::vector<std::uint32_t> ranks_; // per face of the slab
  IndexForest forest_;
  SlabPatches result_;
};

std::vector<SlabPatches> contract_slabs(const FaceSet &faces, const CellLabels &cells, const BasinRanks &ranks,
                                        const Progress &progress)
{
  const std::int64_t planes = faces.samples()[2];
  std::vector<SlabPatches> slabs(static_cast<std::size_t>(slab_count(planes, kPlanesPerSlab)));
  std::atomic<std::int64_t> planes_done{0};
  parallel_for_slabs(planes, kPlanesPerSlab, [&](const Slab &slab) {
    slabs[static_cast<std::size_t>(slab.index)] = SlabContraction(faces, slab).contract(FaceRanks(cells, ranks));
    planes_done += slab.end - slab.begin;
    report_progress(progress, "curve", static_cast<double>(planes_done) / static_cast<double>(planes));
  });
  return slabs;
}

/// The patches and junctions of all slabs, those over the seams between slabs included.
struct PatchGraph {
  std::vector<Patch> patches;
  std::vector<Junction> junctions;
};

/// Adds the junctions between the last plane of a slab and the first of the next.
void join_seam(const FaceSet &faces, std::int64_t z, const std::vector<PatchId> &below,
               const std::vector<PatchId> &above, PatchGraph &graph)
{
  const FaceIndex first_below = faces.faces_before_plane(z - 1);
  const FaceIndex first_above = faces.faces_before_plane(z);
  const auto patch_of = [&](FaceIndex face) {
    return face < first_above ? below[face - first_below] : above[face - first_above];
  };
  EdgeWalk edges(faces, [&](const EdgeFaces &edge) {
    const auto rank = [&](FaceIndex face) { return graph.patches[patch_of(face)].rank; };
    const FaceIndex earliest =
        *std::min_element(edge.begin(), edge.end(), [&](FaceIndex a, FaceIndex b) { return rank(a) < rank(b); });
    for (const FaceIndex face : edge)
      if (patch_of(face) != patch_of(earliest))
        graph.junctions.push_back({rank(face), patch_of(earliest), patch_of(face)});
  });
  edges.walk_with_lower(z);
}

PatchGraph join_slabs(const FaceSet &faces, std::vector<SlabPatches> slabs)
{
  PatchGraph graph;
  std::size_t patches = 0;
  std::size_t junctions = 0;
  for (const SlabPatches &slab : slabs) {
    patches += slab.patches.size();
    junctions += slab.junctions.size();
  }
  graph.patches.reserve(patches);
  graph.junctions.reserve(junctions);
  for (SlabPatches &slab : slabs) {
    const auto offset = static_cast<PatchId>(graph.patches.size());
    graph.patches.insert(graph.patches.end(), slab.patches.begin(), slab.patches.end());
    for (const Junction &junction : slab.junctions)
      graph.junctions.push_back({junction.rank, junction.a + offset, junction.b + offset});
    for (auto *plane : {&slab.lower_plane, &slab.upper_plane})
      for (PatchId &patch : *plane)
        patch += offset;
    slab.patches = {};
    slab.junctions = {};
  }
  for (std::size_t i = 1; i < slabs.size(); ++i)
    join_seam(faces, static_cast<std::int64_t>(i) * kPlanesPerSlab, slabs[i - 1].upper_plane, slabs[i].lower_plane,
              graph);
  return graph;
}

/// What appears at each rank, summed up.
void accumulate(PatchGraph graph, BoundaryCurve &curve)
{
  curve.faces_of_axis.resize(curve.persistence.size());
  curve.components.resize(curve.persistence.size());
  for (const Patch &patch : graph.patches) {
    ++curve.components[patch.rank];
    for (std::size_t axis = 0; axis < 3; ++axis)
      curve.faces_of_axis[patch.rank][axis] += patch.faces_of_axis[axis];
  }
  IndexForest forest(static_cast<std::uint32_t>(graph.patches.size()));
  span(graph.junctions, forest, [&](std::uint32_t rank) { --curve.components[rank]; });
  for (std::size_t rank = 1; rank < curve.persistence.size(); ++rank) {
    curve.components[rank] += curve.components[rank - 1];
    for (std::size_t axis = 0; axis < 3; ++axis)
      curve.faces_of_axis[rank][axis] += curve.faces_of_axis[rank - 1][axis];
  }
}

/// Each basin a side of its own.
Sides sides_of_basins(const BasinRanks &ranks)
{
  Sides sides{std::vector<RegionId>(ranks.persistence.size()), ranks.background};
  std::iota(sides.of_basin.begin(), sides.of_basin.end(), RegionId{0});
  return sides;
}

} // namespace

std::size_t BoundaryCurve::regions_at(double delta) const
{
  const auto is_larger = [](double value, float element) { return value > element; };
  return static_cast<std::size_t>(std::upper_bound(persistence.begin(), persistence.end(), delta, is_larger) -
                                  persistence.begin());
}

std::int64_t BoundaryCurve::faces_at(double delta) const
{
  const auto &faces = faces_of_axis[regions_at(delta) - 1];
  return faces[0] + faces[1] + faces[2];
}

double BoundaryCurve::area_at(double delta) const
{
  const auto &faces = faces_of_axis[regions_at(delta) - 1];
  return static_cast<double>(faces[0]) * face_area_mm2[0] + static_cast<double>(faces[1]) * face_area_mm2[1] +
         static_cast<double>(faces[2]) * face_area_mm2[2];
}

std::int64_t BoundaryCurve::components_at(double delta) const
{
  return components[regions_at(delta) - 1];
}

BoundaryCurve find_boundary_curve(const CellLabels &cells, const Grid &grid, const BasinRanks &ranks,
                                  const Progress &progress)
{
  BoundaryCurve curve;
  curve.persistence = ranks.persistence;
  for (int axis = 0; axis < 3; ++axis)
    curve.face_area_mm2[static_cast<std::size_t>(axis)] = face_area_mm2(grid, axis);
  const FaceSet faces = find_boundary(cells, sides_of_basins(ranks));
  accumulate(join_slabs(faces, contract_slabs(faces, cells, ranks, progress)), curve);
  return curve;
}

} // namespace volsurf
