// The background: the region that what lies outside the volume counts as part of.
//
// Where an exterior node exists, it is that node's region. Where there is none, the hierarchy is followed from its one
// last region down: where a region falls apart as delta decreases, the part with more border faces remains the
// background. So the background at one delta lies within the background at every larger one, and one basin, which this
// finds, stands for it at all of them: a surface with its caps is nested in delta (docs/method.md T6).
#pragma once

#include "volsurf/core/cell_labels.h"
#include "volsurf/topology/hierarchy.h"

namespace volsurf {

/// The number of faces at the border of the volume, per basin. O(border).
std::vector<std::int64_t> count_border_faces(const CellLabels &cells, std::size_t basins);

/// The basin that every background holds, of a hierarchy without exterior. Of parts with as many border faces the one
/// on the elder side remains the background. O(basins).
BasinId find_background(const Hierarchy &hierarchy, std::vector<std::int64_t> border_faces);

} // namespace volsurf
