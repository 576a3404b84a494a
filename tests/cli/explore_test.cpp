// volsurf explore: what each delta would give.
#include "cli/report_of.h"
#include "cli/volsurf_program.h"

#include <filesystem>
#include <map>
#include <regex>
#include <sstream>

namespace volsurf::test {
namespace {

class Explore : public VolsurfProgram {
protected:
  /// What the command prints, with nothing on standard error.
  std::string explored(const std::string &arguments) const
  {
    const Outcome outcome = run("explore " + arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }

  nlohmann::json report(const std::string &arguments) const
  {
    return nlohmann::json::parse(run(arguments + " -q -o surface.vtp --report -").out);
  }
};

using Row = std::array<std::string, 5>; // delta, regions, components, faces, area

std::vector<Row> rows_of(const std::string &csv)
{
  std::vector<Row> rows;
  std::istringstream in(csv);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "delta,regions,components,faces,area_mm2");
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string &field : rows.back())
      std::getline(fields, field, ',');
  }
  return rows;
}

TEST_F(Explore, NeedsMoreMemoryThanACut)
{
  const std::string allowed = head(48) + " --max-memory 82000000"; // 80 MB and 16 bytes per sample are 81.8
  EXPECT_EQ(run(allowed + " --delta 20 -o head.vtp").exit_code, 0);
  expect_refused("explore " + allowed, 3, {"48 x 48 x 48 samples", "--max-memory"});
}

TEST_F(Explore, PrintsTablesAndLeavesNoFile)
{
  const std::string text = explored(head(48));
  for (const std::string part : {"48 x 48 x 48 samples", "regions  components", "area mm2", "--delta auto",
                                 "the noise floor", "a point in it, mm LPS", "What to type next", "--seed="})
    EXPECT_TRUE(contains(text, part));
  EXPECT_EQ(files(), std::set<std::string>{});
}

TEST_F(Explore, RowsOfTheTableAreWhatARunReports)
{
  explored(head(32) + " --csv curve.csv -q");
  const auto rows = rows_of(read_file(work / "curve.csv"));
  ASSERT_GT(rows.size(), 20U);
  for (const std::size_t i : {std::size_t{0}, std::size_t{5}, std::size_t{20}, rows.size() - 1}) {
    const auto counts = report((inputs / "head.nrrd").string() + " --smooth 0 --delta " + rows[i][0]);
    EXPECT_EQ(counts["counts"]["regions"].dump(), rows[i][1]);
    EXPECT_EQ(counts["counts"]["components"].dump(), rows[i][2]);
    EXPECT_EQ(counts["counts"]["boundary_faces"].dump(), rows[i][3]);
    const double area = counts["mesh"]["area_mm2"];
    EXPECT_NEAR(std::stod(rows[i][4]), area, 1e-4 * area);
  }
}

TEST_F(Explore, DeltasOfTheTableFall)
{
  explored(head(48) + " --csv curve.csv -q");
  const auto rows = rows_of(read_file(work / "curve.csv"));
  for (std::size_t i = 1; i < rows.size(); ++i)
    EXPECT_LT(std::stod(rows[i][0]), std::stod(rows[i - 1][0]));
}

TEST_F(Explore, WhatToTypeNextWorksAndGivesTheRegionOfTheTable)
{
  const std::string text = explored(head(48));
  const std::regex command("    volsurf (.*--seed=.*)\n        a prominent region alone, of ([0-9.]+) ml");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(text, match, command)) << text;
  const auto mesh = report(match[1].str() + " --smooth 0")["mesh"];
  EXPECT_GT(mesh["triangles"], 0);
  EXPECT_EQ(mesh["watertight"], true);
  const double volume_ml = std::stod(match[2].str());
  EXPECT_NEAR(mesh["volume_mm3"].get<double>() / 1000, volume_ml, 0.02 * volume_ml);
}

TEST_F(Explore, SuggestsTheDeltaThatAutoTakes)
{
  const std::string scan = head(48) + " --oversample 1";
  const std::string text = explored(scan);
  std::smatch match;
  ASSERT_TRUE(std::regex_search(text, match, std::regex("takes delta ([0-9.]+): ([0-9]+) regions"))) << text;
  EXPECT_EQ(report(scan)["counts"]["regions"].dump(), match[2].str());
}

TEST_F(Explore, PageNeedsNothingElse)
{
  explored(head(32) + " --html page.html -q");
  const std::string page = read_file(work / "page.html");
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0U);
  EXPECT_EQ(page.find("http"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  for (const std::string part : {"data:image/svg+xml;base64,", "head.nrrd", "Prominent regions", "</html>"})
    EXPECT_TRUE(contains(page, part));
}

TEST_F(Explore, PageShowsNamesAsTheyAre)
{
  write_file(inputs / "a<b>&.nrrd", float_nrrd(ball_samples()));
  explored("'" + (inputs / "a<b>&.nrrd").string() + "' --html page.html -q");
  const std::string page = read_file(work / "page.html");
  EXPECT_TRUE(contains(page, "a&lt;b&gt;&amp;.nrrd"));
  EXPECT_EQ(page.find("a<b>"), std::string::npos);
}

TEST_F(Explore, WritesTheSameBytesForAnyNumberOfThreads)
{
  const std::string command = head(48) + " -q --csv a.csv --png a.png --html a.html --threads ";
  std::map<std::string, std::string> first;
  for (const std::string threads : {"1", "2", "3"}) {
    explored(command + threads);
    for (const std::string &name : files()) {
      const auto [bytes, is_new] = first.emplace(name, read_file(work / name));
      EXPECT_TRUE(is_new || bytes->second == read_file(work / name)) << name << " with " << threads << " threads";
    }
  }
  EXPECT_EQ(files(), (std::set<std::string>{"a.csv", "a.html", "a.png"}));
  EXPECT_EQ(first["a.png"].substr(1, 3), "PNG");
}

TEST_F(Explore, FrameRasTurnsTheSeeds)
{
  const std::string lps = explored(ball());
  const std::string ras = explored(ball() + " --frame ras");
  EXPECT_TRUE(contains(lps, " --seed=7.5,7.5,7.5\n")) << lps;
  EXPECT_TRUE(contains(ras, " --seed=-7.5,-7.5,7.5 --frame ras\n")) << ras;
}

TEST_F(Explore, CommandsRepeatWhatDecidesOnTheRegions)
{
  const std::string options = " --median 1 --oversample 2 --sigma 1.5 --exterior infinite";
  EXPECT_TRUE(contains(explored(ball() + options), "ball.nrrd" + options + " --delta "));
}

TEST_F(Explore, TellsWhatItTookWhenVerbose)
{
  const Outcome outcome = run("explore " + ball() + " -v --csv a.csv");
  EXPECT_EQ(outcome.out, "");
  for (const std::string part : {"a.csv: ", "merge ", "time        curve ", "memory "})
    EXPECT_TRUE(contains(outcome.err, part));
}

TEST_F(Explore, HelpNamesItsOptions)
{
  const Outcome help = run("explore --help");
  EXPECT_EQ(help.exit_code, 0);
  for (const std::string option : {"--csv", "--png", "--html", "--sigma", "--exterior", "--frame", "--series",
                                   "--threads", "--max-memory", "--quiet", "--verbose"})
    EXPECT_TRUE(contains(help.out, option));
  EXPECT_TRUE(contains(run("--help").out, "volsurf explore"));
}

TEST_F(Explore, RefusesWhatItCannotUse)
{
  expect_refused("explore", 2, {"INPUT is required", "volsurf explore --help"});
  expect_refused("explore " + ball() + " --delta 3", 2, {"--delta"});
  expect_refused("explore " + ball() + " --csv ''", 2, {"--csv: found \"\""});
  expect_refused("explore " + ball() + " --csv a --png ./a", 2, {"it is named twice"});
  expect_refused("explore " + ball() + " --html " + ball(), 2, {"it is named twice"});
  expect_refused("explore gone.nrrd --png a.png", 3, {"gone.nrrd"});
  expect_refused("explore " + ball() + " --max-memory 1K --png a.png", 3, {"--max-memory"});
  expect_refused("explore " + input("flat.nrrd", float_nrrd(std::vector<float>(18 * 18 * 18, 1))), 4,
                 {"flat.nrrd", "one region at every delta"});
  expect_refused("explore " + ball() + " --png a.png --csv gone/a.csv", 5, {"gone/a.csv"});
}

TEST_F(Explore, AScanOfThatNameIsReadByItsPath)
{
  std::filesystem::create_directory(work / "folder");
  write_file(work / "folder" / "explore", "no scan");
  expect_refused("folder/explore --delta 2 -o a.vtp", 3, {"folder/explore"});
}

} // namespace
} // namespace volsurf::test
