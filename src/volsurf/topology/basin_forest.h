// Sets of basins that Kruskal joins.
#pragma once

#include "volsurf/core/ids.h"

#include <numeric>
#include <vector>

namespace volsurf {

/// Union-find with halving of paths. The caller chooses which representative stays.
class BasinForest {
public:
  explicit BasinForest(std::size_t basins) : parent_(basins) { std::iota(parent_.begin(), parent_.end(), BasinId{0}); }

  BasinId find(BasinId basin)
  {
    while (parent_[basin] != basin) {
      parent_[basin] = parent_[parent_[basin]];
      basin = parent_[basin];
    }
    return basin;
  }

  /// Joins the set of representative `joined` to that of `kept`.
  void join(BasinId kept, BasinId joined) { parent_[joined] = kept; }

private:
  std::vector<BasinId> parent_;
};

} // namespace volsurf
