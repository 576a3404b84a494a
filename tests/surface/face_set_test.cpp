#include "volsurf/surface/face_set.h"

#include "volsurf/core/parallel.h"

#include "support/fields.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tuple>

using namespace volsurf;
using namespace volsurf::support;

namespace {

/// In the order of a FaceSet: z, y, axis, x.
using Place = std::tuple<std::int64_t, std::int64_t, int, std::int64_t>;

/// Sets one face in `one_in` and returns them in order.
std::vector<Place> set_faces(std::int64_t one_in, Dice &dice, FaceSet &faces)
{
  const auto &[nx, ny, nz] = faces.samples();
  std::vector<Place> places;
  for (std::int64_t z = 0; z < nz; ++z)
    for (std::int64_t y = 0; y < ny; ++y)
      for (int axis = 0; axis < 3; ++axis)
        for (std::int64_t x = 0; x < nx; ++x)
          if (dice.one_in(one_in)) {
            faces.row(axis, y, z)[x / 64] |= std::uint64_t{1} << (x % 64);
            places.emplace_back(z, y, axis, x);
          }
  return places;
}

} // namespace

RC_GTEST_PROP(FaceSet, NumbersItsFacesInOrder, ())
{
  Dice dice(*random_seed());
  const ThreadLimit limit(static_cast<int>(dice.between(1, 3)));
  FaceSet faces({dice.between(1, 150), dice.between(1, 3), dice.between(1, 40)});
  const std::vector<Place> places = set_faces(dice.between(1, 30), dice, faces);
  faces.index();
  RC_ASSERT(faces.size() == places.size());
  std::vector<Place> visited;
  std::vector<FaceIndex> before_plane(static_cast<std::size_t>(faces.samples()[2] + 1));
  faces.for_each(0, faces.samples()[2], [&](FaceIndex index, const FacePosition &face) {
    const auto &[x, y, z] = face.corner;
    RC_ASSERT(index == visited.size());
    RC_ASSERT(faces.contains(face.axis, x, y, z));
    RC_ASSERT(faces.index_of(face.axis, x, y, z) == index);
    visited.emplace_back(z, y, face.axis, x);
    for (std::int64_t later = z + 1; later <= faces.samples()[2]; ++later)
      ++before_plane[static_cast<std::size_t>(later)];
  });
  RC_ASSERT(visited == places);
  for (std::int64_t z = 0; z <= faces.samples()[2]; ++z)
    RC_ASSERT(faces.faces_before_plane(z) == before_plane[static_cast<std::size_t>(z)]);
}
