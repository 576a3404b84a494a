// The connected components of a boundary and the choice of which to keep.
//
// Source: the paper, section 5.2.3, and docs/method.md. Faces are connected over shared edges.
#pragma once

#include "volsurf/surface/face_set.h"

#include <string>
#include <variant>
#include <vector>

namespace volsurf {

enum class RankBy {
  faces,  ///< number of faces
  area,   ///< in the world
  radius, ///< largest distance of a component's points from their centroid, in the world
};

struct KeepAll {};
struct KeepCount {
  std::int64_t count; ///< >= 1
};
struct KeepPercent {
  double percent; ///< > 0 and <= 100: the largest ceil(percent of their number)
};
using Keep = std::variant<KeepAll, KeepCount, KeepPercent>;

/// "all", a count as "3", or a percentage as "5%". Throws UsageError.
Keep parse_keep(const std::string &text);

struct ComponentOptions {
  Keep keep = KeepAll{};
  RankBy rank_by = RankBy::faces;
};

struct Components {
  std::vector<ComponentId> of_face; ///< per face index, 1 is the highest rank
  std::vector<double> sizes;        ///< per component id - 1, by what they are ranked by (faces, mm^2, mm), decreasing
  std::size_t kept = 0;             ///< components 1 .. kept are to be kept

  std::size_t count() const { return sizes.size(); }
};

/// Ties are broken by the lowest face (sample of its lowest corner, then axis). Parallel, O(faces).
Components find_components(const FaceSet &faces, const Grid &grid, const ComponentOptions &options);

/// The faces of the kept components, and the component of each of them.
struct KeptFaces {
  FaceSet faces;
  std::vector<ComponentId> component;
};
KeptFaces keep_components(FaceSet faces, const Components &components);

} // namespace volsurf
