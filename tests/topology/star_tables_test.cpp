#include "volsurf/topology/star_tables.h"

#include <gtest/gtest.h>

#include <bitset>

using namespace volsurf;

namespace {

std::size_t hops_between(int a, int b)
{
  return std::bitset<3>(static_cast<unsigned>(a ^ b)).count();
}

/// By the distances in the cube, of which any two octants are joined by a shortest way.
std::size_t hops_to_old(unsigned cells, int octant)
{
  std::size_t hops = kNoLayer;
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

TEST(StarTables, LayerIsTheDistanceToTheNearestOldOctant)
{
  for (unsigned cells = 0; cells < 256; ++cells)
    for (int octant = 0; octant < kOctants; ++octant)
      EXPECT_EQ(star_tables().layer[cells][octant], hops_to_old(cells, octant)) << cells << ' ' << octant;
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

TEST(StarTables, PartsAreJoinedByOldFaces)
{
  for (unsigned faces = 0; faces < 4096; ++faces) {
    unsigned isolated = 0;
    unsigned joined_parts = 0;
    for (int a = 0; a < kOctants; ++a) {
      unsigned part = 0;
      for (int b = 0; b < kOctants; ++b)
        part |= static_cast<unsigned>(old_faces_connect(faces, a, b)) << b;
      ASSERT_EQ(star_tables().parts[faces][a], part) << faces << ' ' << a;
      const bool alone = part == 1U << a;
      isolated |= static_cast<unsigned>(alone) << a;
      joined_parts += !alone && part % (1U << a) == 0 ? 1 : 0;
    }
    EXPECT_EQ(star_tables().lone_and_joined[faces] & 0xFFU, isolated);
    EXPECT_EQ(std::bitset<16>(star_tables().lone_and_joined[faces] >> 8U).count(), joined_parts);
  }
}
