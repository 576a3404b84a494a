// A set of faces of the cubical complex as bit planes.
#pragma once

#include "volsurf/core/buffer.h"
#include "volsurf/core/grid.h"

#include <cstdint>

namespace volsurf {

/// The index of a face among those of its set: dense, ascending by (z, y, axis, x) of the lowest corner.
using FaceIndex = std::uint32_t;

/// A face: its axis (it is normal to it) and its lowest corner's sample. It lies between the cells at the corner and
/// one lower along the axis.
struct FacePosition {
  int axis;
  Index3 corner;
};

/// One bit per sample and axis, and the number of faces before each word: a face's index costs one popcount, with no
/// hash and no search. 0.6 bytes per sample.
class FaceSet {
public:
  explicit FaceSet(const Index3 &samples);

  const Index3 &samples() const { return samples_; }
  std::int64_t words_per_row() const { return words_per_row_; }

  /// The words of one row of faces; bit x % 64 of word x / 64. Rows may be written by several threads, then call
  /// index().
  std::uint64_t *row(int axis, std::int64_t y, std::int64_t z) { return &words_[row_start(axis, y, z)]; }
  const std::uint64_t *row(int axis, std::int64_t y, std::int64_t z) const { return &words_[row_start(axis, y, z)]; }

  /// Numbers the faces. Throws Error where there are 2^32 or more.
  void index();

  FaceIndex size() const { return size_; }

  /// False for positions outside the volume too.
  bool contains(int axis, std::int64_t x, std::int64_t y, std::int64_t z) const
  {
    if (x < 0 || y < 0 || z < 0 || x >= samples_[0] || y >= samples_[1] || z >= samples_[2])
      return false;
    return (row(axis, y, z)[x >> 6] >> (x & 63) & 1U) != 0;
  }

  /// The index of a face of the set.
  FaceIndex index_of(int axis, std::int64_t x, std::int64_t y, std::int64_t z) const
  {
    const std::int64_t word = row_start(axis, y, z) + (x >> 6);
    const std::uint64_t before = words_[word] & ((std::uint64_t{1} << (x & 63)) - 1);
    return faces_before_[word] + static_cast<FaceIndex>(__builtin_popcountll(before));
  }

  /// The number of faces before word `word` of a row.
  FaceIndex faces_before(int axis, std::int64_t word, std::int64_t y, std::int64_t z) const
  {
    return faces_before_[row_start(axis, y, z) + word];
  }

  /// The number of faces before plane z (0 .. samples()[2]).
  FaceIndex faces_before_plane(std::int64_t z) const
  {
    return z == samples_[2] ? size_ : faces_before_[row_start(0, 0, z)];
  }

  /// The number of faces before the faces of all axes at (y, z).
  FaceIndex faces_before_row(std::int64_t y, std::int64_t z) const { return faces_before_[row_start(0, y, z)]; }

  /// Calls visit(index, FacePosition) for the faces of planes z_begin .. z_end-1, in order.
  template <typename Visit> void for_each(std::int64_t z_begin, std::int64_t z_end, Visit visit) const
  {
    for (std::int64_t z = z_begin; z < z_end; ++z)
      for (std::int64_t y = 0; y < samples_[1]; ++y)
        for_each_in_row(y, z, visit);
  }

  /// The same for the faces of all axes at (y, z).
  template <typename Visit> void for_each_in_row(std::int64_t y, std::int64_t z, Visit visit) const
  {
    FaceIndex index = faces_before_row(y, z);
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint64_t *const words = row(axis, y, z);
      for (std::int64_t w = 0; w < words_per_row_; ++w)
        for (std::uint64_t rest = words[w]; rest != 0; rest &= rest - 1)
          visit(index++, FacePosition{axis, {64 * w + __builtin_ctzll(rest), y, z}});
    }
  }

private:
  std::int64_t row_start(int axis, std::int64_t y, std::int64_t z) const
  {
    return ((z * samples_[1] + y) * 3 + axis) * words_per_row_;
  }

  Index3 samples_;
  std::int64_t words_per_row_;
  Buffer<std::uint64_t> words_;
  Buffer<FaceIndex> faces_before_;
  FaceIndex size_ = 0;
};

} // namespace volsurf
