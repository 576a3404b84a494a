// Masks, their surfaces and back, on grids of any orientation.
#include "support/solids.h"
#include "volsurf/compare/mask.h"
#include "volsurf/compare/overlap.h"
#include "volsurf/compare/tidy_mesh.h"
#include "volsurf/compare/voxelise.h"
#include "volsurf/core/error.h"
#include "volsurf/surface/check.h"

#include <gtest/gtest.h>
#include <itkImage.h>
#include <itkLabelOverlapMeasuresImageFilter.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace volsurf::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

Grid skew_grid(const Index3 &size, bool mirrored)
{
  Grid grid;
  grid.size = size;
  grid.spacing_mm = {0.8, 1.5, 2.25};
  grid.origin_mm = {-30, 12, 5};
  grid.direction = skew_rotation();
  if (mirrored)
    for (Vec3 &row : grid.direction)
      row[0] = -row[0];
  return grid;
}

/// Labels 0 to 2 at random.
Volume some_labels()
{
  const auto size = *rc::gen::container<Index3>(rc::gen::inRange<std::int64_t>(2, 7));
  Volume volume;
  volume.grid = skew_grid(size, *rc::gen::arbitrary<bool>());
  volume.samples = *rc::gen::container<std::vector<float>>(static_cast<std::size_t>(volume.grid.sample_count()),
                                                           rc::gen::element(0.0F, 1.0F, 2.0F));
  return volume;
}

RC_GTEST_PROP(Mask, surface_is_closed_outward_and_holds_the_samples_again, ())
{
  const Volume volume = some_labels();
  const Mask mask = mask_of_labels(volume, {2});
  RC_PRE(!mask.inside.empty());
  const Mesh mesh = mask_surface(mask);
  RC_ASSERT(count_unbalanced_edges(mesh) == 0);
  RC_ASSERT(signed_volume_mm3(mesh) > 0);
  RC_ASSERT(voxelise(mesh, mask.grid).inside == mask.inside);
}

RC_GTEST_PROP(Mask, has_the_labels_asked_for_and_a_margin, ())
{
  const Volume volume = some_labels();
  const Mask mask = mask_of_labels(volume, {});
  const auto count = std::count_if(volume.samples.begin(), volume.samples.end(), [](float s) { return s > 0; });
  RC_ASSERT(count_inside(mask) == count);
  RC_PRE(count > 0);
  const auto offset = common_lattice(volume.grid, mask.grid);
  RC_ASSERT(offset.has_value());
  const GridBox back{{-(*offset)[0], -(*offset)[1], -(*offset)[2]}, volume.grid.size};
  const Mask whole = on_box(mask, back);
  for (std::size_t i = 0; i < volume.samples.size(); ++i)
    RC_ASSERT((whole.inside[i] != 0) == (volume.samples[i] > 0));
}

TEST(Mask, WithoutSuchLabelsIsEmpty)
{
  Volume volume;
  volume.grid.size = {2, 2, 2};
  volume.samples.assign(8, 1);
  EXPECT_TRUE(mask_of_labels(volume, {7}).inside.empty());
}

TEST(Mask, LatticesAreTheSameOnlyWhereSamplesFallOnEachOther)
{
  const Grid grid = skew_grid({5, 6, 7}, false);
  Grid other = grid;
  other.origin_mm = index_to_world(grid, {2, -3, 4});
  ASSERT_TRUE(common_lattice(grid, other).has_value());
  EXPECT_EQ(*common_lattice(grid, other), (Index3{2, -3, 4}));
  other.origin_mm = index_to_world(grid, {2.01, -3, 4});
  EXPECT_FALSE(common_lattice(grid, other).has_value());
  other = grid;
  other.spacing_mm[1] *= 1.01;
  EXPECT_FALSE(common_lattice(grid, other).has_value());
  other = grid;
  other.direction = kNoRotation;
  EXPECT_FALSE(common_lattice(grid, other).has_value());
}

TEST(Voxelise, TakesWhatLiesOnTheSurfaceOnOneSideOnly)
{
  Grid grid;
  grid.size = {8, 8, 8};
  const Mask one = voxelise(box_mesh({1, 1, 1}, {4, 4, 4}), grid);
  const Mask next = voxelise(box_mesh({4, 1, 1}, {6, 4, 4}), grid);
  EXPECT_EQ(count_inside(one), 27);
  EXPECT_EQ(count_inside(next), 18);
  EXPECT_EQ(measure_overlap(one, next).samples_both, 0) << "neighbours share no sample";
}

TEST(Voxelise, CountsNestedAndOverlappingBodies)
{
  Grid grid;
  grid.size = {12, 12, 12};
  const Mesh outer = box_mesh({0.5, 0.5, 0.5}, {8.5, 8.5, 8.5});
  Mesh hole = box_mesh({2.5, 2.5, 2.5}, {4.5, 4.5, 4.5});
  EXPECT_EQ(count_inside(voxelise(joined(outer, hole), grid)), 512) << "a body inside of another changes nothing";
  for (Triangle &t : hole.triangles)
    std::swap(t[1], t[2]);
  EXPECT_EQ(count_inside(voxelise(joined(outer, hole), grid)), 512 - 8) << "a hole does";
  const Mesh beyond = box_mesh({6.5, -20, 0.5}, {40, 40, 8.5});
  EXPECT_EQ(count_inside(voxelise(joined(outer, beyond), grid)), 512 + 8 * (5 * 12 - 2 * 8))
      << "and it may reach out of the grid";
}

TEST(Voxelise, HoldsTheVolumeOfASphere)
{
  const Mesh sphere = sphere_mesh({3, -4, 5}, 10, 5);
  Grid grid = skew_grid({60, 60, 60}, true);
  grid.spacing_mm = {0.5, 0.6, 0.7};
  const Vec3 middle = index_to_world(grid, {29.7, 29.2, 29.4});
  grid.origin_mm = {grid.origin_mm[0] + 3 - middle[0], grid.origin_mm[1] - 4 - middle[1],
                    grid.origin_mm[2] + 5 - middle[2]};
  const Mask mask = voxelise(sphere, grid);
  const double volume = static_cast<double>(count_inside(mask)) * voxel_volume_mm3(grid);
  EXPECT_NEAR(volume, signed_volume_mm3(sphere), 0.002 * volume);
  EXPECT_NEAR(volume, 4.0 / 3 * kPi * 1000, 0.005 * volume);
}

TEST(Overlap, OfConcentricSpheresFollowsTheirVolumes)
{
  const Overlap o = measure_overlap(sphere_mesh({0, 0, 0}, 11, 5), sphere_mesh({0, 0, 0}, 10, 5));
  const double ratio = std::pow(10.0 / 11, 3);
  EXPECT_NEAR(o.dice, 2 * ratio / (1 + ratio), 1e-3);
  EXPECT_NEAR(o.jaccard, ratio, 1e-3);
}

TEST(Overlap, OfBoxesIsThatWorkedOutByHand)
{
  const Mesh a = box_mesh({0, 0, 0}, {4, 4, 4});
  const Mesh b = box_mesh({2, 0, 0}, {6, 4, 4});
  const Overlap o = measure_overlap(a, b, 0.125);
  EXPECT_DOUBLE_EQ(o.dice, 0.5);
  EXPECT_DOUBLE_EQ(o.jaccard, 1.0 / 3);
  EXPECT_EQ(o.samples_a, 32 * 32 * 32);
}

TEST(Overlap, OfAMaskAndASurfaceSeesWhatLiesBeyondTheGrid)
{
  Volume volume;
  volume.grid.size = {4, 4, 4};
  volume.samples.assign(64, 1);
  const Mask mask = mask_of_labels(volume, {});
  const Overlap o = measure_overlap(mask, box_mesh({-0.5, -0.5, -0.5}, {7.5, 3.5, 3.5}));
  EXPECT_EQ(o.samples_a, 64);
  EXPECT_EQ(o.samples_b, 128);
  EXPECT_EQ(o.samples_both, 64);
}

TEST(Overlap, RefusesAGridThatNoMemoryHolds)
{
  const Mesh near = box_mesh({0, 0, 0}, {1, 1, 1});
  EXPECT_THROW(measure_overlap(near, near, 1e-4), InputError);
  Volume volume;
  volume.grid.size = {2, 2, 2};
  volume.samples.assign(8, 1);
  EXPECT_THROW(measure_overlap(mask_of_labels(volume, {}), box_mesh({0, 0, 0}, {1e6, 1e6, 1e6})), InputError);
}

using ItkMask = itk::Image<std::uint8_t, 3>;

ItkMask::Pointer to_itk(const Mask &mask)
{
  const auto image = ItkMask::New();
  ItkMask::SizeType size;
  for (unsigned int axis = 0; axis < 3; ++axis)
    size[axis] = static_cast<std::size_t>(mask.grid.size[axis]);
  image->SetRegions(size);
  image->Allocate();
  std::copy(mask.inside.begin(), mask.inside.end(), image->GetBufferPointer());
  return image;
}

RC_GTEST_PROP(Overlap, is_that_of_itk, ())
{
  const Volume volume = some_labels();
  Volume other = volume;
  other.samples = *rc::gen::container<std::vector<float>>(volume.samples.size(), rc::gen::element(0.0F, 1.0F));
  const Mask a = mask_of_labels(volume, {2});
  const Mask b = mask_of_labels(other, {});
  RC_PRE(!a.inside.empty() && !b.inside.empty());
  const std::optional<Overlap> o = measure_lattice_overlap(a, b);
  RC_ASSERT(o.has_value());
  const auto filter = itk::LabelOverlapMeasuresImageFilter<ItkMask>::New();
  const auto on_the_volume = [&](const Mask &mask) {
    const Index3 offset = *common_lattice(mask.grid, volume.grid);
    return to_itk(on_box(mask, {offset, volume.grid.size}));
  };
  filter->SetSourceImage(on_the_volume(a));
  filter->SetTargetImage(on_the_volume(b));
  filter->Update();
  RC_ASSERT(std::abs(o->dice - filter->GetDiceCoefficient(1)) < 1e-12);
  RC_ASSERT(std::abs(o->jaccard - filter->GetJaccardCoefficient(1)) < 1e-12);
}

} // namespace
} // namespace volsurf::test
