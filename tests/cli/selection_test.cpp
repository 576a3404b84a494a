// Which regions a surface goes around.
#include "cli/report_of.h"
#include "cli/volsurf_program.h"

namespace volsurf::test {
namespace {

using nlohmann::json;

/// A cell of the tests' scans has 1 mm3. The balls are regions 2 to 28, the largest first; the background is region 1.
class SelectionOfRegions : public VolsurfProgram {
protected:
  json report(const std::string &arguments) const
  {
    const Outcome outcome = run(arguments + " --report -");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << ": " << outcome.err;
    return report_of(outcome);
  }

  std::string scan() const { return balls() + " --delta 2 --sigma 0 --smooth 0"; }

  /// The cells of the balls, from the largest on: unsmoothed volumes.
  std::vector<std::int64_t> ball_cells() const
  {
    const json whole = report(scan() + " --split regions -o ball.stl");
    std::vector<std::int64_t> cells;
    for (const json &surface : whole["surfaces"])
      cells.push_back(std::llround(surface["volume_mm3"].get<double>()));
    EXPECT_EQ(cells.size(), 27U);
    cells.resize(27);
    return cells;
  }
};

/// Two boxes in a dark cube that touch, and a third one away from them: regions 2, 3 and 4 by size.
std::vector<float> samples_of_boxes()
{
  std::vector<float> samples;
  for (int z = 0; z < 24; ++z)
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) {
        const bool first = x >= 3 && x < 9 && y >= 3 && y < 15 && z >= 3 && z < 15;
        const bool second = x >= 9 && x < 13 && y >= 3 && y < 15 && z >= 3 && z < 15;
        const bool third = x >= 17 && x < 21 && y >= 17 && y < 21 && z >= 17 && z < 21;
        samples.push_back(first ? 100.0F : second ? 300.0F : third ? 200.0F : 0.0F);
      }
  return samples;
}

TEST_F(SelectionOfRegions, ARegionIsTheOneOfASeedInIt)
{
  const json all = report(scan());
  for (const int strength : {0, 1, 7, 19}) {
    const json &region = all["strongest_regions"][strength];
    const json &p = region["maximum_mm"];
    const std::string seed = p[0].dump() + "," + p[1].dump() + "," + p[2].dump();
    const json by_seed = report(scan() + " --seed " + seed);
    const json by_number = report(scan() + " --region " + region["id"].dump());
    EXPECT_EQ(by_number["mesh"], by_seed["mesh"]) << region;
    EXPECT_EQ(by_number["options"]["region_numbers"], json({region["id"]}));
  }
}

TEST_F(SelectionOfRegions, SeedsAndRegionsAddUpAndARegionNamedTwiceIsOne)
{
  const json all = report(scan());
  const json &p = all["strongest_regions"][3]["maximum_mm"];
  const std::string number = all["strongest_regions"][3]["id"].dump();
  const std::string other = all["strongest_regions"][5]["id"].dump();
  const std::string seed = " --seed " + p[0].dump() + "," + p[1].dump() + "," + p[2].dump();
  const json mixed = report(scan() + seed + " --region " + other);
  EXPECT_EQ(mixed["mesh"], report(scan() + " --region " + other + " --region " + number)["mesh"]);
  EXPECT_EQ(mixed["mesh"]["shells"], 2);
  EXPECT_EQ(report(scan() + seed + " --region " + number)["mesh"], report(scan() + seed)["mesh"]);
}

TEST_F(SelectionOfRegions, MinVolumeKeepsTheRegionsThatHaveIt)
{
  const std::vector<std::int64_t> cells = ball_cells();
  EXPECT_TRUE(std::is_sorted(cells.rbegin(), cells.rend()));
  for (const std::int64_t least : {cells[0], cells[0] - 1, cells[10], cells[10] + 1, cells[26], std::int64_t{0}}) {
    const auto expected = std::count_if(cells.begin(), cells.end(), [&](auto volume) { return volume >= least; });
    ASSERT_GT(expected, 0);
    const std::string option = " --min-volume " + std::to_string(least);
    EXPECT_EQ(report(scan() + option)["mesh"]["shells"], expected) << least;
    EXPECT_EQ(report(scan() + " --surface hull" + option)["mesh"]["shells"], expected) << "each ball is an island";
  }
}

TEST_F(SelectionOfRegions, NothingAsLargeAsMinVolumeIsAnEmptyResultThatTellsTheLargest)
{
  const std::string largest = std::to_string(ball_cells()[0]);
  for (const std::string surface : {"all", "hull"})
    expect_refused(scan() + " --surface " + surface + " --min-volume 1e6", 4,
                   {surface == "all" ? "no region has" : "no island has", "--min-volume 1e+06 mm3",
                    "the largest beside the background has " + largest + " mm3"});
}

TEST_F(SelectionOfRegions, AHullKeepsSmallRegionsOfLargeIslands)
{
  const std::string boxes =
      input("boxes.nrrd", float_nrrd(samples_of_boxes(), "24 24 24")) + " --delta 20 --sigma 0 --smooth 0";
  const json all = report(boxes);
  ASSERT_EQ(all["counts"]["regions"], 4);
  const auto volume = [&](const std::string &options) {
    return std::llround(report(boxes + options)["mesh"]["volume_mm3"].get<double>());
  };
  const auto first = volume(" --region 2");
  const auto second = volume(" --region 3");
  const auto third = volume(" --region 4");
  ASSERT_GT(second, third);
  EXPECT_EQ(volume(" --surface hull"), first + second + third);
  const std::string least = " --min-volume " + std::to_string(second + 1);
  EXPECT_EQ(volume(" --surface hull" + least), first + second) << "the second one is part of a larger island";
  EXPECT_EQ(volume(least), first) << "by itself it is too small";
}

TEST_F(SelectionOfRegions, ConfigFileHoldsThem)
{
  const std::string config = input("o.ini", "delta = 2\nsigma = 0\nregion = 3\nregion = 5\nsplit = regions\n");
  const json options = report(balls() + " --config " + config)["options"];
  EXPECT_EQ(options["region_numbers"], json({3, 5}));
  EXPECT_EQ(options["split"], "regions");
  EXPECT_EQ(options["command_line"].get<std::string>().find("--region 3 --region 5") == std::string::npos, false);
}

} // namespace
} // namespace volsurf::test
