// One file for each component or region.
#include "cli/report_of.h"
#include "cli/volsurf_program.h"

#include <array>
#include <sstream>

namespace volsurf::test {
namespace {

using nlohmann::json;

class SplitFiles : public VolsurfProgram {
protected:
  json report(const std::string &arguments) const
  {
    const Outcome outcome = run(arguments + " --report -");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << ": " << outcome.err;
    return report_of(outcome);
  }

  std::string scan() const { return balls() + " --delta 2 --sigma 0"; }
};

/// The triangles of an OBJ file by their corners' coordinates, as text, in order.
std::vector<std::string> triangles_of(const std::string &obj)
{
  std::istringstream lines(obj);
  std::vector<std::string> points;
  std::vector<std::string> triangles;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(std::min<std::size_t>(2, line.size())));
    if (line[0] == 'v')
      points.push_back(words.str());
    std::array<std::size_t, 3> corners{};
    if (line[0] == 'f' && words >> corners[0] >> corners[1] >> corners[2])
      triangles.push_back(points.at(corners[0] - 1) + ", " + points.at(corners[1] - 1) + ", " +
                          points.at(corners[2] - 1));
  }
  return triangles;
}

/// 8 bright blocks along each axis of a dark cube.
std::vector<float> samples_of_512_blocks()
{
  std::vector<float> samples;
  for (int z = 0; z < 48; ++z)
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x)
        samples.push_back(x % 6 / 3 + y % 6 / 3 + z % 6 / 3 == 3 ? 100.0F : 0.0F);
  return samples;
}

TEST_F(SplitFiles, NumbersHaveAsManyDigitsAsTheHighest)
{
  report(scan() + " --region 3 --region 7 --region 12 --split regions -o 'my head.v1.obj' -o ./b.STL");
  EXPECT_EQ(files(),
            (std::set<std::string>{"my head.v1_region_03.obj", "my head.v1_region_07.obj", "my head.v1_region_12.obj",
                                   "b_region_03.STL", "b_region_07.STL", "b_region_12.STL"}));
}

TEST_F(SplitFiles, ARegionsFileHoldsItsOwnSurface)
{
  for (const std::string options : {" --delta 10", " --delta 10 --smooth 0 --keep 1 --rank-by area --frame ras"}) {
    const std::string head_scan = head(48) + options;
    const json whole = report(head_scan + " --min-volume 5000 --split regions -o parts.obj");
    ASSERT_GT(whole["surfaces"].size(), 3U);
    std::int64_t triangles = 0;
    for (const json &surface : whole["surfaces"]) {
      const json alone = report(head_scan + " --region " + surface["region"].dump() + " -o alone.obj");
      EXPECT_EQ(triangles_of(read_file(work / surface["files"][0])), triangles_of(read_file(work / "alone.obj")));
      EXPECT_EQ(surface["watertight"], true);
      for (const std::string key : {"triangles", "watertight", "volume_mm3", "volume_drift"})
        EXPECT_EQ(surface[key], alone["mesh"][key]) << key;
      triangles += surface["triangles"].get<std::int64_t>();
    }
    EXPECT_EQ(whole["mesh"]["triangles"], triangles);
  }
}

TEST_F(SplitFiles, TheBackgroundHasNoFile)
{
  const json whole = report(scan() + " --split regions -o a.stl");
  EXPECT_EQ(whole["surfaces"].size(), 27U);
  EXPECT_EQ(files().count("a_region_01.stl"), 0U);
  EXPECT_EQ(files().size(), 27U);
}

TEST_F(SplitFiles, ComponentsHoldTheTrianglesOfTheWholeAsTheyAreThere)
{
  const std::string head_scan = head(48) + " --delta 10 --keep 4";
  report(head_scan + " -o whole.obj");
  const json split = report(head_scan + " --split components -o part.obj");
  std::vector<std::string> whole = triangles_of(read_file(work / "whole.obj"));
  std::vector<std::string> parts;
  const std::size_t count = split["surfaces"].size();
  ASSERT_GT(count, 1U);
  EXPECT_EQ(split["counts"]["components_kept"], count);
  for (std::size_t i = 0; i < count; ++i) {
    const json &surface = split["surfaces"][i];
    EXPECT_EQ(surface["component"], i + 1);
    EXPECT_EQ(surface["files"], json({"part_component_" + std::to_string(i + 1) + ".obj"}));
    const auto triangles = triangles_of(read_file(work / surface["files"][0]));
    EXPECT_EQ(triangles.size(), surface["triangles"]);
    EXPECT_EQ(triangles.size(), 2 * split["component_sizes"][i].get<std::size_t>()) << "two per face";
    parts.insert(parts.end(), triangles.begin(), triangles.end());
  }
  std::sort(whole.begin(), whole.end());
  std::sort(parts.begin(), parts.end());
  EXPECT_EQ(parts, whole);
}

TEST_F(SplitFiles, TellsTheSmoothingOfEachClosedComponent)
{
  const json smooth = report(scan() + " --smooth 1 --split components -o a.stl");
  const json rough = report(scan() + " --smooth 0 --split components -o a.stl");
  for (std::size_t i = 0; i < 27; ++i) {
    const double before = rough["surfaces"][i]["volume_mm3"];
    const double after = smooth["surfaces"][i]["volume_mm3"];
    EXPECT_NEAR(smooth["surfaces"][i]["volume_drift"].get<double>(), after / before - 1, 1e-5);
    EXPECT_NEAR(rough["surfaces"][i]["volume_drift"].get<double>(), 0, 1e-12);
  }
}

TEST_F(SplitFiles, VolumesAreWrittenWhole)
{
  report(scan() + " --split regions -o a.vdb -o a.ply --labels l.nrrd");
  EXPECT_EQ(files().count("a.vdb"), 1U);
  EXPECT_EQ(files().count("l.nrrd"), 1U);
  EXPECT_EQ(files().size(), 2U + 27U);
  EXPECT_EQ(files().count("a.ply"), 0U);
}

TEST_F(SplitFiles, MoreThanAThousandFilesAreRefused)
{
  const std::string blocks = input("blocks.nrrd", float_nrrd(samples_of_512_blocks(), "48 48 48")) +
                             " --delta 2 --sigma 0 --smooth 0 --split ";
  const json counts = report(blocks + "components --keep 500 -o a.stl -o a.ply")["counts"];
  EXPECT_EQ(counts["components_kept"], 500);
  EXPECT_EQ(files().size(), 1000U);
  expect_refused(blocks + "components -o b.stl -o b.ply", 2,
                 {"--split components: found 1024 files", "allowed are up to 1000", "--keep"});
  expect_refused(blocks + "regions -o b.stl -o b.ply", 2,
                 {"--split regions: found 1024 files", "allowed are up to 1000", "--min-volume, --region"});
}

TEST_F(SplitFiles, AppearTogetherOrNotAtAll)
{
  std::filesystem::create_directory(work / "a_region_20.stl");
  const auto before = files();
  const Outcome outcome = run(scan() + " --split regions -o a.stl");
  EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "a_region_20.stl: found a folder"));
  EXPECT_EQ(files(), before);
  expect_refused(scan() + " --split regions -o gone/a.stl", 5, {"the folder gone does not exist"});
}

TEST_F(SplitFiles, NeverTakeTheNameOfAnotherFile)
{
  expect_refused(scan() + " --split regions -o a.stl --report a_region_05.stl", 2,
                 {"a_region_05.stl: it is named twice"});
  write_file(work / "b.stl", "");
  std::filesystem::create_symlink("b.stl", work / "a_region_03.stl");
  std::filesystem::create_symlink("b.stl", work / "a_region_10.stl");
  expect_refused(scan() + " --split regions --region 3 --region 10 -o a.stl", 2, {"b.stl: it is named twice"});
}

} // namespace
} // namespace volsurf::test
