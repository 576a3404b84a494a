#include "volsurf/surface/face_set.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"
#include "volsurf/core/vectorise.h"

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace volsurf {

namespace {

constexpr std::int64_t kPlanesPerSlab = 16;

/// Compiled for processors that count bits, too: elsewhere it is a function call for each word.
VOLSURF_VECTORISE
std::uint64_t count_faces(const std::uint64_t *words, const std::uint64_t *end)
{
  std::uint64_t faces = 0;
  for (; words != end; ++words)
    faces += static_cast<std::uint64_t>(__builtin_popcountll(*words));
  return faces;
}

/// Writes the number of faces before each word; `faces` are before the first.
VOLSURF_VECTORISE
void number_faces(const std::uint64_t *words, const std::uint64_t *end, std::uint64_t faces, FaceIndex *before)
{
  for (; words != end; ++words) {
    *before++ = static_cast<FaceIndex>(faces);
    faces += static_cast<std::uint64_t>(__builtin_popcountll(*words));
  }
}

/// Calls visit(slab, begin, end) with the words of slabs of planes, on all threads.
template <typename Visit> void for_each_slab(std::int64_t planes, std::int64_t words, const Visit &visit)
{
  const std::int64_t words_per_plane = words / planes;
  parallel_for_slabs(planes, kPlanesPerSlab, [&](const Slab &slab) {
    visit(static_cast<std::size_t>(slab.index), slab.begin * words_per_plane, slab.end * words_per_plane);
  });
}

} // namespace

FaceSet::FaceSet(const Index3 &samples)
    : samples_(samples), words_per_row_((samples[0] + 63) / 64),
      words_(Buffer<std::uint64_t>::zeros(samples[1] * samples[2] * 3 * words_per_row_))
{
}

void FaceSet::index()
{
  const std::int64_t planes = samples_[2];
  std::vector<std::uint64_t> faces_before_slab(static_cast<std::size_t>(slab_count(planes, kPlanesPerSlab)));
  for_each_slab(planes, words_.size(), [&](std::size_t slab, std::int64_t begin, std::int64_t end) {
    faces_before_slab[slab] = count_faces(words_.data() + begin, words_.data() + end);
  });
  std::uint64_t faces = 0;
  for (std::uint64_t &before : faces_before_slab)
    faces += std::exchange(before, faces);
  if (faces > std::numeric_limits<FaceIndex>::max())
    throw Error("the boundary has " + std::to_string(faces) + " faces; at most 4294967295 are allowed: raise delta");
  size_ = static_cast<FaceIndex>(faces);

  faces_before_ = Buffer<FaceIndex>::zeros(words_.size()); // large pages cost more here than they save
  for_each_slab(planes, words_.size(), [&](std::size_t slab, std::int64_t begin, std::int64_t end) {
    number_faces(words_.data() + begin, words_.data() + end, faces_before_slab[slab], faces_before_.data() + begin);
  });
}

} // namespace volsurf
