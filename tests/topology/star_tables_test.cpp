#include "volsurf/topology/star_tables.h"

#include <gtest/gtest.h>

#include <bitset>

using namespace volsurf;

namespace {

constexpr std::size_t kNowhere = 99;

std::size_t hops_between(int a, int b)
{
  return std::bitset<3>(static_cast<unsigned>(a ^ b)).count();
}

/// By the distances in the cube, of which any two octants are joined by a shortest way.
std::size_t hops_to_old(unsigned cells, int octant)
{
  std::size_t hops = kNowhere;
  for (int other = 0; other < kOctants; ++other)
    if ((cells >> other & 1U) == 0)
      hops = std::min(hops, hops_between(octant, other));
  return hops;
}

bool old_faces_connect(unsigned faces, int a, int b)
{
  unsigned reached = 1U << a;
  for (int round = 0; round < kOctants; ++round)
    for (int f = 0; f < kStarFaces; ++f)
      if ((faces >> f & 1U) == 0 && ((reached >> lower_octant(f) | reached >> upper_octant(f)) & 1U) != 0)
        reached |= 1U << lower_octant(f) | 1U << upper_octant(f);
  return (reached >> b & 1U) != 0;
}

} // namespace

TEST(StarFaces, LieBetweenOctantsThatDifferInTheirAxis)
{
  for (int f = 0; f < kStarFaces; ++f) {
    EXPECT_EQ(upper_octant(f) - lower_octant(f), 1 << (f / 4));
    EXPECT_EQ(star_face_of(lower_octant(f), f / 4), f);
    EXPECT_EQ(star_face_of(upper_octant(f), f / 4), f);
  }
}

TEST(StarTables, LayerOfAFaceIsTheDistanceOfItsNearerOctantToAnOldOne)
{
  for (unsigned cells = 0; cells < 256; ++cells)
    for (int f = 0; f < kStarFaces; ++f)
      for (std::size_t layer = 0; layer < kFaceLayers; ++layer)
        EXPECT_EQ((star_tables().layer_faces[cells][layer] >> f & 1U) != 0,
                  std::min(hops_to_old(cells, lower_octant(f)), hops_to_old(cells, upper_octant(f))) == layer)
            << cells << ' ' << f;
}

TEST(StarTables, FirstLayerOfSomeFacesIsTheLowestThatTheyHave)
{
  for (unsigned cells = 0; cells < 255; ++cells)
    for (unsigned faces = 1; faces < 4096; ++faces) {
      const auto &layers = star_tables().layer_faces[cells];
      std::size_t layer = 0;
      while ((faces & layers[layer]) == 0)
        ++layer;
      ASSERT_EQ(star_tables().of_first_layer(faces, cells), faces & layers[layer]) << cells << ' ' << faces;
    }
}

TEST(StarTables, FacesAcrossAnAxisAreThoseOfTheOctants)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (unsigned octants = 0; octants < 256; ++octants)
      for (int f = 0; f < kStarFaces; ++f)
        EXPECT_EQ((star_tables().faces_across[axis][octants] >> f & 1U) != 0,
                  f / 4 == static_cast<int>(axis) &&
                      ((octants >> lower_octant(f) | octants >> upper_octant(f)) & 1U) != 0);
}

TEST(StarTables, DeepFacesAreThoseAlongTheAxesOfDeepOctants)
{
  for (unsigned cells = 0; cells < 255; ++cells) {
    unsigned expected = 0;
    for (int octant = 0; octant < kOctants; ++octant)
      if ((star_tables().deep[cells] >> octant & 1U) != 0)
        expected |= 1U << star_face_of(octant, star_tables().deep_axis[cells][octant]);
    EXPECT_EQ(star_tables().deep_faces[cells], expected) << cells;
  }
}

TEST(StarTables, DeepAxisIsTheFirstOneThatLeadsTowardsAnOldOctant)
{
  for (unsigned cells = 0; cells < 255; ++cells)
    for (int octant = 0; octant < kOctants; ++octant) {
      if ((cells >> octant & 1U) == 0)
        continue;
      int expected = 0;
      while (hops_to_old(cells, octant ^ (1 << expected)) >= hops_to_old(cells, octant))
        ++expected;
      EXPECT_EQ(star_tables().deep_axis[cells][octant], expected) << cells << ' ' << octant;
    }
}

TEST(StarTables, DeepOctantsAreTwoOrMoreHopsFromAnOldOne)
{
  for (unsigned cells = 0; cells < 256; ++cells)
    for (int octant = 0; octant < kOctants; ++octant)
      EXPECT_EQ((star_tables().deep[cells] >> octant & 1U) != 0, hops_to_old(cells, octant) >= 2)
          << cells << ' ' << octant;
}

TEST(StarTables, InnerFacesLieBetweenTwoOctantsOfTheSet)
{
  for (unsigned octants = 0; octants < 256; ++octants)
    for (int f = 0; f < kStarFaces; ++f)
      EXPECT_EQ((star_tables().inner_faces[octants] >> f & 1U) != 0,
                (octants >> lower_octant(f) & octants >> upper_octant(f) & 1U) != 0);
}

TEST(StarTables, JoiningFacesLieBetweenOctantsThatOldFacesDoNotConnect)
{
  for (unsigned faces = 0; faces < 4096; ++faces)
    for (int f = 0; f < kStarFaces; ++f)
      ASSERT_EQ((star_tables().joining[faces] >> f & 1U) != 0,
                !old_faces_connect(faces, lower_octant(f), upper_octant(f)))
          << faces << ' ' << f;
}

TEST(StarTables, PartsAreLoneOrJoinedByOldFaces)
{
  for (unsigned faces = 0; faces < 4096; ++faces) {
    unsigned isolated = 0;
    unsigned joined_parts = 0;
    for (int a = 0; a < kOctants; ++a) {
      unsigned part = 0;
      for (int b = 0; b < kOctants; ++b)
        part |= static_cast<unsigned>(old_faces_connect(faces, a, b)) << b;
      const bool alone = part == 1U << a;
      isolated |= static_cast<unsigned>(alone) << a;
      joined_parts += !alone && part % (1U << a) == 0 ? 1 : 0;
    }
    EXPECT_EQ(star_tables().lone_and_joined[faces] & 0xFFU, isolated);
    EXPECT_EQ(std::bitset<16>(star_tables().lone_and_joined[faces] >> 8U).count(), joined_parts);
  }
}
