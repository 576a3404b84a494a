// Command lines that cannot be meant: exit code 2 and one line that says what was found and what is allowed.
#include "cli/volsurf_program.h"

namespace volsurf::test {
namespace {

class BadUsage : public VolsurfProgram {
protected:
  void expect_usage(const std::string &options, const std::vector<std::string> &parts) const
  {
    expect_refused(ball() + " " + options, 2, parts);
  }
};

TEST_F(BadUsage, DeltaMustBeAFiniteNumberAboveZero)
{
  for (const std::string delta : {"0", "-1", "nan", "inf", "text", "1e999", "5x"})
    expect_usage("--delta " + delta, {"--delta: found \"" + delta + "\"; allowed are finite numbers above 0"});
}

TEST_F(BadUsage, RegionsIsACountThatTheScanCanHave)
{
  for (const std::string count : {"1", "0", "-3", "2.5", "many"})
    expect_usage("--regions " + count, {"--regions", count});
  expect_usage("--regions 100000000", {"--regions: found 100000000; allowed are 2 to "});
  expect_usage("--regions 3 --delta 2", {"--regions", "--delta"});
}

TEST_F(BadUsage, NoOptionTakesAnEmptyText)
{
  for (const std::string option : {"--delta", "--sigma", "--keep", "--seed", "--output", "--labels", "--report",
                                   "--save-hierarchy", "--series", "--iterations", "--frame", "--config"})
    expect_usage((option == "--delta" ? "" : "--delta 2 ") + option + " ''", {option + ": found \"\""});
  expect_refused("'' --delta 2", 2, {"INPUT: found \"\""});
}

TEST_F(BadUsage, KeepIsAllACountOrAPercentage)
{
  for (const std::string keep : {"0%", "101%", "0", "-1", "text", "1.5", "nan%"})
    expect_usage("--delta 2 --keep " + keep, {"--keep: found \"" + keep + "\"; allowed are all, a count"});
}

TEST_F(BadUsage, InputIsRequired)
{
  expect_refused("--delta 2", 2, {"INPUT is required"});
}

TEST_F(BadUsage, UnknownOptionsAndFurtherInputsAreNamed)
{
  expect_usage("--delta 2 --bogus", {"--bogus"});
  expect_usage("--delta 2 another.nrrd", {"another.nrrd"});
}

TEST_F(BadUsage, OptionsOfOneValueAreGivenOnce)
{
  expect_usage("--delta 2 --delta 3", {"--delta"});
  expect_usage("--delta 2 --keep 1 --keep 2", {"--keep"});
}

TEST_F(BadUsage, PaperSetsSigmaExteriorAndFieldItself)
{
  expect_usage("--delta 2 --paper --sigma 1", {"--paper", "--sigma"});
  expect_usage("--delta 2 --paper --median 1", {"--paper", "--median"});
  expect_usage("--delta 2 --paper --oversample 2", {"--paper", "--oversample"});
  expect_usage("--delta 2 --paper --exterior none", {"--paper", "--exterior"});
  expect_usage("--delta 2 --paper --edge-map", {"--paper", "--edge-map"});
  expect_usage("--delta 2 --edge-map --sigma 1", {"--edge-map", "--sigma"});
}

TEST_F(BadUsage, SeedsAreThreeNumbers)
{
  for (const std::string seed : {"1,2", "1,2,3,4", "a,b,c", "1;2;3", "nan,0,0"})
    expect_usage("--delta 2 --seed '" + seed + "'", {"--seed: found \"" + seed + "\"; allowed are three numbers"});
}

TEST_F(BadUsage, SeedsLieInTheVolume)
{
  expect_usage("--delta 2 --seed 8,8,17.1", {"--seed 8,8,17.1: it lies outside the volume"});
  expect_usage("--delta 2 --frame ras --seed 8,8,8", {"--seed 8,8,8: it lies outside the volume"});
}

TEST_F(BadUsage, SeedAndHullExcludeEachOther)
{
  expect_usage("--delta 2 --seed 8,8,8 --surface hull", {"--seed", "--surface hull"});
}

TEST_F(BadUsage, RegionsAreNumbersOfRegions)
{
  for (const std::string region : {"0", "-1", "text", "1.5", "2x", "99999999999999999999"})
    expect_usage("--delta 2 --region=" + region, {"--region: found \"" + region + "\"; allowed are whole numbers"});
  expect_usage("--delta 2 --region 2 --region 3", {"--region: found 3; allowed are 1 to 2: there are 2 regions"});
}

TEST_F(BadUsage, NamedRegionsExcludeChoicesAmongAll)
{
  expect_usage("--delta 2 --region 2 --surface hull", {"--region", "--surface hull"});
  expect_usage("--delta 2 --region 2 --min-volume 5", {"--region", "--min-volume"});
  expect_usage("--delta 2 --seed 8,8,8 --min-volume 5", {"--seed", "--min-volume"});
}

TEST_F(BadUsage, ASplitNeedsSomethingToSplit)
{
  expect_usage("--delta 2 --split regions --surface hull", {"--split regions", "--surface hull", "--split components"});
  expect_usage("--delta 2 --split regions -o a.vdb", {"--split: found no output that it can split"});
  expect_usage("--delta 2 --split regions --region 1", {"--split regions: found region 1, the background"});
}

TEST_F(BadUsage, WordsOutsideTheDocumentedOnesAreAnsweredWithThem)
{
  expect_usage("--delta 2 --frame xyz", {"--frame: found \"xyz\"; allowed are lps, ras"});
  expect_usage("--delta 2 --frame 0", {"--frame: found \"0\"; allowed are lps, ras"});
  expect_usage("--delta 2 --snap 1", {"--snap: found \"1\"; allowed are on, off"});
  expect_usage("--delta 2 --exterior 1", {"--exterior: found \"1\"; allowed are none, infinite"});
  expect_usage("--delta 2 --surface both", {"--surface: found \"both\"; allowed are all, hull"});
  expect_usage("--delta 2 --split files", {"--split: found \"files\"; allowed are none, components, regions"});
  expect_usage("--delta 2 --rank-by volume", {"--rank-by: found \"volume\"; allowed are faces, area, radius"});
}

TEST_F(BadUsage, NumbersOutOfRangeAreAnsweredWithTheRange)
{
  expect_usage("--delta 2 --threads -1", {"--threads", "-1", "0 to 1024"});
  for (const std::string radius : {"-1", "4"})
    expect_usage("--delta 2 --median " + radius, {"--median", radius, "0 to 3"});
  expect_usage("--delta 2 --median 1.5", {"--median", "1.5"});
  expect_usage("--delta 2 --smooth 2", {"--smooth: found 2; allowed are 0 to 1"});
  expect_usage("--delta 2 --smooth nan", {"--smooth: found nan; allowed are 0 to 1"});
  expect_usage("--delta 2 --passband 0", {"--passband: found 0; allowed are 0.001 to 2"});
  expect_usage("--delta 2 --iterations 1", {"--iterations: found 1; allowed are 15 to 1000"});
  for (const std::string volume : {"-1", "nan", "inf"})
    expect_usage("--delta 2 --min-volume " + volume, {"--min-volume: found " + volume, "allowed are finite numbers"});
  expect_usage("--delta 2 --sigma -1", {"--sigma: found -1; allowed are 0 to 64 mm"});
  for (const std::string factor : {"0", "3"})
    expect_usage("--delta 2 --oversample " + factor, {"--oversample", factor, "1 to 2"});
}

TEST_F(BadUsage, OptionsAreCheckedBeforeTheInputIsRead)
{
  expect_refused("gone.nrrd --delta 2 --smooth 2", 2, {"--smooth"});
  expect_refused("gone.nrrd --delta 2 -o out.xyz", 2, {"out.xyz"});
}

TEST_F(BadUsage, OutputExtensionsAreTheKnownOnes)
{
  for (const std::string name : {"out.xyz", "out.VTK", "out.vtp.gz"})
    expect_usage("--delta 2 -o good.vtp -o " + name, {name + ": found the extension", "allowed: .vtp, .stl, .ply"});
  expect_usage("--delta 2 -o folder/", {"folder/: found no extension"});
  expect_usage("--delta 2 --labels labels.nii", {"labels.nii: found the extension .nii; allowed: .nrrd"});
}

TEST_F(BadUsage, OutputOverTheInputIsRefusedAndTheInputStays)
{
  write_file(work / "scan.nrrd", float_nrrd(ball_samples()));
  std::filesystem::create_symlink("scan.nrrd", work / "link.nrrd");
  const std::string twice = "scan.nrrd: it is named twice; inputs and outputs must be different files";
  expect_refused("scan.nrrd --delta 2 --labels scan.nrrd", 2, {twice});
  expect_refused("scan.nrrd --delta 2 --labels ./../" + work.path().filename().string() + "/scan.nrrd", 2, {twice});
  expect_refused("scan.nrrd --delta 2 --labels link.nrrd", 2, {twice});
  expect_refused("link.nrrd --delta 2 --report scan.nrrd", 2, {twice});
  EXPECT_EQ(read_file(work / "scan.nrrd"), float_nrrd(ball_samples()));
}

TEST_F(BadUsage, OutputsMustDiffer)
{
  expect_usage("--delta 2 -o out.vtp -o out.vtp", {"out.vtp: it is named twice"});
  expect_usage("--delta 2 -o out.vtp -o ./out.vtp", {"out.vtp: it is named twice"});
  expect_usage("--delta 2 -o out.stl --report " + (work / "out.stl").string(), {"out.stl: it is named twice"});
}

TEST_F(BadUsage, QuietAndVerboseExcludeEachOther)
{
  expect_usage("--delta 2 -q -v", {"--quiet", "--verbose"});
}

TEST_F(BadUsage, ConfigFileIsReadableAndHoldsOptionsOnly)
{
  expect_usage("--config gone.ini", {"gone.ini"});
  expect_usage("--config " + input("unknown.ini", "delta = 2\nbogus = 3\n"), {"unknown.ini", "bogus"});
  expect_usage("--config " + input("range.ini", "delta = -2\n"), {"--delta: found \"-2\""});
  expect_usage("--config " + input("noise.ini", std::string("\1\2\0\3garbage", 11)), {"noise.ini"});
}

} // namespace
} // namespace volsurf::test
