#include "volsurf/surface/fairing.h"

#include "support/fields.h"

#include "volsurf/core/parallel.h"
#include "volsurf/core/vec3.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace volsurf;
using namespace volsurf::support;

namespace {

constexpr int kSide = 32;

/// A square sheet of points, one unit apart.
struct Sheet {
  Sheet()
  {
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        mesh.points.push_back({static_cast<float>(x), static_cast<float>(y), 0});
    for (int y = 0; y + 1 < kSide; ++y)
      for (int x = 0; x + 1 < kSide; ++x) {
        const auto corner = static_cast<PointId>(x + kSide * y);
        mesh.triangles.push_back({corner, corner + 1, corner + kSide + 1});
        mesh.triangles.push_back({corner, corner + kSide + 1, corner + kSide});
      }
  }

  /// Targets and shape, at heights.
  template <typename Height> std::vector<Vec3> at(Height height) const
  {
    std::vector<Vec3> positions;
    for (const Point &p : mesh.points)
      positions.push_back({p[0], p[1], height(static_cast<double>(p[0]), static_cast<double>(p[1]))});
    return positions;
  }

  /// Far enough from the border, where the sheet bends as it ends.
  static bool is_inner(std::size_t point)
  {
    const std::size_t x = point % kSide;
    const std::size_t y = point / kSide;
    return std::min(x, y) >= 8 && std::max(x, y) < kSide - 8;
  }

  Mesh mesh;
};

std::vector<Target> targets_at(const std::vector<Vec3> &positions, double error)
{
  std::vector<Target> targets(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    targets[i].position = positions[i];
    targets[i].error = error;
  }
  return targets;
}

std::vector<Vec3> with_noise(std::vector<Vec3> positions, double sd)
{
  std::mt19937 engine(7);
  std::normal_distribution<double> noise(0, sd);
  for (Vec3 &p : positions)
    p[2] += noise(engine);
  return positions;
}

double rms_of_inner(const std::vector<Vec3> &found, const std::vector<Vec3> &expected)
{
  double squared = 0;
  int count = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (Sheet::is_inner(i)) {
      squared += std::pow(found[i][2] - expected[i][2], 2);
      ++count;
    }
  return std::sqrt(squared / count);
}

double dome(double x, double y)
{
  return -((x - 16) * (x - 16) + (y - 16) * (y - 16)) / 40;
}

double roof(double x, double)
{
  return -0.7 * std::abs(x - 16);
}

} // namespace

TEST(FairPositions, APlaneStaysAsItIs)
{
  const Sheet sheet;
  const auto plane = sheet.at([](double x, double y) { return 0.3 * x - 0.2 * y; });
  const auto found = fair_positions(PointNeighbours(sheet.mesh), targets_at(plane, 0.3), plane);
  EXPECT_LT(rms_of_inner(found, plane), 5e-3);
}

TEST(FairPositions, CertainPointsStayWhateverTheirNeighboursSay)
{
  const Sheet sheet;
  const auto rough = with_noise(sheet.at(dome), 0.2);
  const auto found = fair_positions(PointNeighbours(sheet.mesh), targets_at(rough, 1e-4), sheet.at(dome));
  // But for the quarter of a bend by which the points of a dome stand above it.
  const auto smooth = sheet.at(dome);
  EXPECT_LT(rms_of_inner(found, rough), 0.06);
  EXPECT_GT(rms_of_inner(found, smooth), 0.15);
}

TEST(FairPositions, NoiseOfUncertainPointsIsEvenedOutAndTheCurvatureStays)
{
  const Sheet sheet;
  const auto smooth = sheet.at(dome);
  for (const double noise : {0.1, 0.3}) {
    const auto found =
        fair_positions(PointNeighbours(sheet.mesh), targets_at(with_noise(smooth, noise), noise), smooth);
    EXPECT_LT(rms_of_inner(found, smooth), noise / 3) << noise;
  }
}

TEST(FairPositions, WhatIsFoldedByItselfKeepsItsFolds)
{
  const Sheet sheet;
  const auto folded = sheet.at([](double x, double y) { return 0.2 * (std::sin(0.9 * x) + std::sin(0.9 * y)); });
  const auto off_by = [&](const MeshSampling &sampling) {
    const auto targets = targets_at(folded, 0.3);
    return rms_of_inner(fair_positions(PointNeighbours(sheet.mesh), targets, folded, sampling), folded);
  };
  const MeshSampling uneven{1, false};
  EXPECT_LT(off_by({}), 0.7 * off_by(uneven)) << "where points lie unevenly, bends say nothing of folds";
}

TEST(FairPositions, OnAFinerGridNoiseIsEvenedOutOverMorePoints)
{
  const Sheet sheet;
  const auto smooth = sheet.at(dome);
  const auto noisy = with_noise(smooth, 0.3);
  const auto rms_at = [&](int oversampling) {
    const auto found =
        fair_positions(PointNeighbours(sheet.mesh), targets_at(noisy, 0.3 * oversampling), noisy, {oversampling});
    return rms_of_inner(found, smooth);
  };
  EXPECT_LT(rms_at(2), 0.8 * rms_at(1));
}

TEST(FairPositions, PointsThatKnowNothingGoWhereTheSurfaceBendsLeast)
{
  const Sheet sheet;
  const auto plane = sheet.at([](double x, double y) { return 0.3 * x - 0.2 * y; });
  auto targets = targets_at(plane, 0.03);
  for (std::size_t i = 0; i < targets.size(); i += 2) {
    targets[i].position[2] += 1;
    targets[i].error = 1e3;
  }
  EXPECT_LT(rms_of_inner(fair_positions(PointNeighbours(sheet.mesh), targets, plane), plane), 0.01);
}

TEST(FairPositions, ACreaseInTheTargetsStaysSharp)
{
  const Sheet sheet;
  const auto sharp = sheet.at(roof);
  const auto found = fair_positions(PointNeighbours(sheet.mesh), targets_at(sharp, 0.05), sharp);
  EXPECT_LT(rms_of_inner(found, sharp), 0.06);
}

TEST(FairPositions, FlatTrianglesOfADomeAreOnItOnAverage)
{
  const Sheet sheet;
  const auto smooth = sheet.at(dome);
  const auto found = fair_positions(PointNeighbours(sheet.mesh), targets_at(smooth, 0.01), smooth);
  double above = 0;
  double chord = 0;
  int count = 0;
  const auto height_over_dome = [](const Vec3 &p) { return p[2] - dome(p[0], p[1]); };
  for (const Triangle &t : sheet.mesh.triangles)
    if (Sheet::is_inner(t[0]) && Sheet::is_inner(t[1]) && Sheet::is_inner(t[2])) {
      for (int part = 0; part < 36; ++part) { // the middles of 36 equal parts of the unit square's lower half
        const double u = (part % 6 + 0.5) / 6;
        const double v = (part / 6 + 0.5) / 6;
        const double a = u + v < 1 ? u : 1 - u;
        const double b = u + v < 1 ? v : 1 - v;
        const auto mix = [&](const std::vector<Vec3> &x) {
          return plus(plus(scaled(1 - a - b, x[t[0]]), a, x[t[1]]), b, x[t[2]]);
        };
        above += height_over_dome(mix(found));
        chord += height_over_dome(mix(smooth));
        ++count;
      }
    }
  EXPECT_LT(chord / count, -0.005);
  EXPECT_LT(std::abs(above), 0.35 * std::abs(chord));
}

TEST(FairPositions, FixedAxesStayFixed)
{
  const Sheet sheet;
  const auto shape = sheet.at(dome);
  auto targets = targets_at(with_noise(shape, 0.3), 0.3);
  for (Target &target : targets)
    target.free_axes = {true, true, false};
  const auto found = fair_positions(PointNeighbours(sheet.mesh), targets, shape);
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_EQ(found[i][2], shape[i][2]);
}

TEST(FairPositions, AFeatureIsFairAlongItselfOnly)
{
  // A ridge of targets; the sheet beside it lies flat.
  const Sheet sheet;
  const auto shape = sheet.at([](double x, double) { return 0 * x; });
  auto targets = targets_at(shape, 0.5);
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (i % kSide == 16) {
      targets[i].on_feature = true;
      targets[i].position[2] = 1;
      targets[i].error = 0.03;
    }
  const auto found = fair_positions(PointNeighbours(sheet.mesh), targets, shape);
  for (int y = 8; y < kSide - 8; ++y)
    EXPECT_NEAR(found[16 + kSide * y][2], 1, 0.05);
}

TEST(FairPositions, IsTheSameForAnyNumberOfThreads)
{
  const Sheet sheet;
  const auto shape = sheet.at(dome);
  const auto targets = targets_at(with_noise(shape, 0.2), 0.2);
  const PointNeighbours neighbours(sheet.mesh);
  const auto expected = fair_positions(neighbours, targets, shape);
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(fair_positions(neighbours, targets, shape), expected);
  }
}

TEST(FairPositions, AsksForTargetsAtThePlacesFoundWithTheLastOnes)
{
  const Sheet sheet;
  const std::vector<Vec3> shape = sheet.at([](double, double) { return 0.0; });
  std::vector<double> heights;
  const auto one_further = [&](const std::vector<Vec3> &places) {
    const std::size_t middle = kSide / 2 * kSide + kSide / 2;
    heights.push_back(places[middle][2]);
    std::vector<Target> targets = targets_at(places, 0.01);
    for (Target &target : targets)
      target.position[2] += 1;
    return targets;
  };
  const std::vector<Vec3> places = fair_positions(PointNeighbours(sheet.mesh), one_further, 3, shape);
  ASSERT_EQ(heights.size(), 3U);
  for (std::size_t round = 0; round < 3; ++round)
    EXPECT_NEAR(heights[round], static_cast<double>(round), 0.05);
  for (const Vec3 &place : places)
    EXPECT_NEAR(place[2], 3, 0.05);
}
