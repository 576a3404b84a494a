// Union-find over the indices 0 .. size-1.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace volsurf {

/// The representative of a set is its lowest index, however the sets were joined. Threads may work on it together as
/// long as no two of them touch indices of one set.
class IndexForest {
public:
  explicit IndexForest(std::uint32_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

  /// Halves the path to the representative.
  std::uint32_t find(std::uint32_t index)
  {
    while (parent_[index] != index) {
      parent_[index] = parent_[parent_[index]];
      index = parent_[index];
    }
    return index;
  }

  /// False where both were in one set already.
  bool join(std::uint32_t a, std::uint32_t b)
  {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

private:
  std::vector<std::uint32_t> parent_;
};

} // namespace volsurf
