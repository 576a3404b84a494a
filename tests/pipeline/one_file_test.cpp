// One file answers every delta: the triangles of a surface whose Persistence reaches D are the surface at D.
#include "volsurf/pipeline/run.h"
#include "volsurf/pipeline/stored_merge.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

using namespace volsurf;
using namespace volsurf::test;

namespace {

using Point = std::array<double, 3>;

/// Three points in order, so that a triangle is known whatever its winding.
using PointTriple = std::array<Point, 3>;

struct Surface {
  std::vector<PointTriple> triangles; ///< sorted
  std::size_t caps = 0;
};

vtkDataArray &cell_array(vtkPolyData &mesh, const char *name)
{
  vtkDataArray *const array = mesh.GetCellData()->GetArray(name);
  if (array == nullptr)
    throw std::runtime_error(std::string("no cell array ") + name);
  return *array;
}

/// What ParaView's Threshold leaves of a file: the triangles whose Persistence is at least `delta`.
Surface thresholded(const std::filesystem::path &file, double delta)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData &mesh = *reader->GetOutput();
  vtkDataArray &persistence = cell_array(mesh, "Persistence");
  vtkDataArray &cap = cell_array(mesh, "Cap");
  Surface surface;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell) {
    if (!(persistence.GetTuple1(cell) >= delta))
      continue;
    vtkIdType count = 0;
    const vtkIdType *points = nullptr;
    mesh.GetCellPoints(cell, count, points);
    PointTriple triangle{};
    for (std::size_t i = 0; i < 3; ++i)
      mesh.GetPoint(points[i], triangle[i].data());
    std::sort(triangle.begin(), triangle.end());
    surface.triangles.push_back(triangle);
    surface.caps += cap.GetTuple1(cell) != 0 ? 1 : 0;
  }
  std::sort(surface.triangles.begin(), surface.triangles.end());
  return surface;
}

/// Up to `count` deltas at which a boundary vanishes just above, from three regions to `most_regions`; the least first.
std::vector<double> deltas_of(const Hierarchy &hierarchy, std::size_t most_regions, std::size_t count)
{
  const std::size_t last = std::min(most_regions, hierarchy.basin_count()) - 1;
  std::set<double> deltas;
  for (std::size_t i = 0; i < count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count - 1);
    const auto rank = static_cast<std::size_t>(2 * std::pow(static_cast<double>(last) / 2, part));
    deltas.insert(hierarchy.persistence[hierarchy.by_rank[rank]]);
  }
  return {deltas.begin(), deltas.end()};
}

class OneFile : public testing::Test {
protected:
  Settings settings_of(const std::filesystem::path &input, DeltaChoice delta, const std::string &output) const
  {
    Settings settings;
    settings.input = input;
    settings.delta = delta;
    settings.smoothing.strength = 0;
    settings.outputs = {folder / output};
    return settings;
  }

  void expect_every_delta(const std::filesystem::path &scan, Exterior exterior) const
  {
    const std::filesystem::path hierarchy = folder / "scan.volsurf";
    Settings first = settings_of(scan, DeltaRegions{100}, "first.stl");
    first.exterior = exterior;
    first.hierarchy = hierarchy;
    run(first);

    const std::vector<double> deltas = deltas_of(read_merge(hierarchy).merge.hierarchy, 300, 11);
    ASSERT_EQ(deltas.size(), 11U);
    run(settings_of(hierarchy, DeltaValue{deltas.front()}, "all.vtp"));
    std::size_t caps = 0;
    for (const double delta : deltas) {
      run(settings_of(hierarchy, DeltaValue{delta}, "cut.vtp"));
      const Surface expected = thresholded(folder / "cut.vtp", 0);
      const Surface found = thresholded(folder / "all.vtp", delta);
      ASSERT_FALSE(expected.triangles.empty());
      EXPECT_TRUE(found.triangles == expected.triangles)
          << "delta " << delta << ": " << found.triangles.size() << " of " << expected.triangles.size();
      EXPECT_EQ(found.caps, expected.caps) << delta;
      caps += expected.caps;
    }
    EXPECT_GT(caps, 0U) << "the border is put to no test";
  }

  const TemporaryFolder folder;
};

std::filesystem::path real_volume(const std::string &name)
{
  const char *const named = std::getenv("VOLSURF_DATA");
  return std::filesystem::path(named != nullptr ? named : VOLSURF_REAL_DATA) / name;
}

} // namespace

TEST_F(OneFile, AnswersEveryDeltaOfThePhantom)
{
  expect_every_delta(VOLSURF_SOURCE "/data/brain.nrrd", Exterior::none);
}

TEST_F(OneFile, AnswersEveryDeltaOfThePhantomInAnInfiniteExterior)
{
  expect_every_delta(VOLSURF_SOURCE "/data/brain.nrrd", Exterior::infinite);
}

TEST_F(OneFile, AnswersEveryDeltaOfAHead)
{
  const std::filesystem::path scan = real_volume("ch2.nii.gz");
  if (!std::filesystem::exists(scan))
    GTEST_SKIP() << scan.string() << " is not there; `scripts/fetch_data.sh DIR` fetches it, VOLSURF_DATA=DIR names "
                 << "the folder";
  expect_every_delta(scan, Exterior::none);
  expect_every_delta(scan, Exterior::infinite);
}
