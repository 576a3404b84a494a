#include "volsurf/surface/face_set.h"

#include "volsurf/core/error.h"

#include <limits>
#include <string>

namespace volsurf {

FaceSet::FaceSet(const Index3 &samples)
    : samples_(samples), words_per_row_((samples[0] + 63) / 64),
      words_(static_cast<std::size_t>(samples[1] * samples[2] * 3 * words_per_row_))
{
}

void FaceSet::index()
{
  faces_before_.resize(words_.size());
  std::uint64_t faces = 0;
  for (std::size_t word = 0; word < words_.size(); ++word) {
    faces_before_[word] = static_cast<FaceIndex>(faces);
    faces += static_cast<std::uint64_t>(__builtin_popcountll(words_[word]));
  }
  if (faces > std::numeric_limits<FaceIndex>::max())
    throw Error("the boundary has " + std::to_string(faces) + " faces; at most 4294967295 are allowed: raise delta");
  size_ = static_cast<FaceIndex>(faces);
}

} // namespace volsurf
