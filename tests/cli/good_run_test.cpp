// What the options promise.
#include "cli/report_of.h"
#include "cli/volsurf_program.h"

#include <array>
#include <sstream>

namespace volsurf::test {
namespace {

class GoodRun : public VolsurfProgram {
protected:
  /// The report of a run that must succeed.
  nlohmann::json report(const std::string &arguments) const
  {
    const Outcome outcome = run(arguments + " --report -");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << ": " << outcome.err;
    return report_of(outcome);
  }

  void expect_done(const std::string &arguments) const
  {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments << ": " << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
  }
};

std::string after_header(const std::string &nrrd)
{
  return nrrd.substr(nrrd.find("\n\n"));
}

/// The lines of an OBJ file without its comments, which name input and options.
std::string without_comments(const std::string &obj)
{
  std::istringstream lines(obj);
  std::string rest;
  for (std::string line; std::getline(lines, line);)
    if (line[0] != '#')
      rest += line + '\n';
  return rest;
}

std::vector<std::array<double, 3>> vertices(const std::string &obj)
{
  std::istringstream lines(obj);
  std::vector<std::array<double, 3>> points;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    std::array<double, 3> point{};
    if (words >> kind >> point[0] >> point[1] >> point[2] && kind == "v")
      points.push_back(point);
  }
  return points;
}

/// |grad g| of the ball by central differences, one-sided at the border, in float32 and in the program's order.
std::vector<float> ball_gradient_magnitude()
{
  const std::vector<float> g = ball_samples();
  const auto derivative = [&g](int index, int position, int stride) {
    if (position == 0)
      return g[index + stride] - g[index];
    if (position == kBallSize - 1)
      return g[index] - g[index - stride];
    return (g[index + stride] - g[index - stride]) * 0.5F;
  };
  std::vector<float> magnitude(g.size());
  for (int z = 0, i = 0; z < kBallSize; ++z)
    for (int y = 0; y < kBallSize; ++y)
      for (int x = 0; x < kBallSize; ++x, ++i) {
        const float gx = derivative(i, x, 1);
        const float gy = derivative(i, y, kBallSize);
        const float gz = derivative(i, z, kBallSize * kBallSize);
        magnitude[i] = std::sqrt((gx * gx + gy * gy) + gz * gz);
      }
  return magnitude;
}

TEST_F(GoodRun, DefaultOutputIsTheInputsStemInTheCurrentFolder)
{
  const std::string bytes = float_nrrd(ball_samples());
  expect_done(input("plain.nrrd", bytes) + " --delta 2");
  expect_done(input("v1.2.NRRD", bytes) + " --delta 2");
  expect_done("'" + input("d\xC3\xBCnn \xE6\x97\xA5.nrrd", bytes) + "' --delta 2");
  EXPECT_EQ(files(), (std::set<std::string>{"plain.vtp", "v1.2.vtp", "d\xC3\xBCnn \xE6\x97\xA5.vtp"}));
}

TEST_F(GoodRun, DefaultOutputOfNiftiDropsBothExtensions)
{
  NiftiHeader header;
  header.sizes = {kBallSize, kBallSize, kBallSize};
  header.datatype = 16;
  header.bits = 32;
  const std::string bytes = header.bytes() + bytes_of(ball_samples());
  expect_done(input("a.nii", bytes) + " --delta 2");
  expect_done(input("b.nii.gz", gzip(bytes)) + " --delta 2");
  EXPECT_EQ(files(), (std::set<std::string>{"a.vtp", "b.vtp"}));
}

TEST_F(GoodRun, WritesEachFormatInOneRun)
{
  std::filesystem::create_directory(work / "sub folder");
  expect_done(ball() + " --delta 2 -o a.vtp -o a.STL -o 'sub folder/a.ply' -o ./a.obj -o a.vdb");
  EXPECT_EQ(files(), (std::set<std::string>{"a.vtp", "a.STL", "sub folder", "a.obj", "a.vdb"}));
  EXPECT_TRUE(contains(read_file(work / "a.vtp").substr(0, 200), "<VTKFile type=\"PolyData\""));
  EXPECT_TRUE(contains(read_file(work / "a.STL").substr(0, 80), "SPACE=LPS"));
  EXPECT_EQ(read_file(work / "sub folder/a.ply").substr(0, 4), "ply\n");
  EXPECT_TRUE(contains(read_file(work / "a.obj"), "\nv "));
  EXPECT_EQ(read_file(work / "a.vdb").substr(0, 4), " BDV");
}

TEST_F(GoodRun, OutputReplacesWhatALinkPointsTo)
{
  std::filesystem::create_symlink("real.obj", work / "link.obj");
  expect_done(ball() + " --delta 2 -o link.obj");
  EXPECT_TRUE(std::filesystem::is_symlink(work / "link.obj"));
  EXPECT_TRUE(contains(read_file(work / "real.obj"), "\nv "));
}

TEST_F(GoodRun, LabelsLieOverTheScan)
{
  const std::string place =
      "space: left-posterior-superior\nspace origin: (10,20,30)\nspace directions: (1,0,0) (0,2,0) "
      "(0,0,4)\n";
  const std::string run = input("placed.nrrd", float_nrrd(ball_samples(), kBallSizes, place)) + " --delta 2";
  expect_done(run + " --labels l.nrrd");
  const std::string labels = read_file(work / "l.nrrd");
  EXPECT_TRUE(contains(labels, "\nspace: left-posterior-superior\n"));
  EXPECT_TRUE(contains(labels, "\nsizes: 17 17 17\n"));
  EXPECT_TRUE(contains(labels, "\nspace directions: (1,0,0) (0,2,0) (0,0,4)\n"));
  EXPECT_TRUE(contains(labels, "\nspace origin: (10.5,21,32)\n")) << "cells' centres, half a voxel further";
  expect_done(run + " --oversample 2 --labels fine.nrrd");
  const std::string fine = read_file(work / "fine.nrrd");
  EXPECT_TRUE(contains(fine, "\nsizes: 34 34 34\n"));
  EXPECT_TRUE(contains(fine, "\nspace directions: (0.5,0,0) (0,1,0) (0,0,2)\n"));
  EXPECT_TRUE(contains(fine, "\nspace origin: (10.25,20.5,31)\n"));
}

TEST_F(GoodRun, ReportOnStandardOutputIsAllThatIsPrintedThere)
{
  const Outcome to_stdout = run(ball() + " --delta 2 -q --report -");
  EXPECT_FALSE(report_of(to_stdout).is_discarded());
  EXPECT_EQ(to_stdout.err, "");
  expect_done(ball() + " --delta 2 --report r.json");
  EXPECT_EQ(nlohmann::json::parse(read_file(work / "r.json"))["mesh"], report_of(to_stdout)["mesh"]);
}

TEST_F(GoodRun, QuietPrintsNothingAndVerboseTellsEachStage)
{
  EXPECT_EQ(run(ball() + " --delta 2 --quiet").err, "");
  const std::string normal = run(ball() + " --delta 2 --smooth 0").err;
  EXPECT_TRUE(is_one_line(normal)) << normal;
  EXPECT_TRUE(contains(normal, "ball.vtp: "));
  const std::string verbose = run(ball() + " --delta 2 -v").err;
  for (const std::string word : {"volume ", "merge ", "regions ", "mesh ", "smoothing ", "time ", "memory "})
    EXPECT_TRUE(contains(verbose, word));
}

TEST_F(GoodRun, WarnsWhereSmoothingShrinksABody)
{
  const std::string smooth_away = ball() + " --delta 2 --surface hull --smooth 1 --iterations 300 --snap off";
  EXPECT_TRUE(contains(run(smooth_away).err, "warning: smoothing shrinks the enclosed volume by "));
  EXPECT_FALSE(contains(run(ball() + " --delta 2 --surface hull").err, "warning"));
}

TEST_F(GoodRun, VerboseTellsTheExpectedMemoryBeforeTheWorkStarts)
{
  const Outcome outcome = run(ball() + " --delta 2 -v --max-memory 1M");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_TRUE(contains(outcome.err, "volume      18 x 18 x 18 samples of 1 x 1 x 1 mm\n"));
  EXPECT_TRUE(contains(outcome.err, "MB expected without the mesh\nvolsurf: "));
}

TEST_F(GoodRun, VerboseTellsOfAFinerGrid)
{
  const Outcome outcome = run(ball() + " --delta 2 --oversample 2 -v --max-memory 1M");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_TRUE(
      contains(outcome.err, "volume      35 x 35 x 35 samples of 0.5 x 0.5 x 0.5 mm, twice as fine as the scan\n"));
}

/// Three plates of 20 x 20 x 2 voxels, whose walls face each other, and a thick one, in a volume of n^3.
std::vector<float> samples_of_plates(int n)
{
  std::vector<float> samples;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const bool in_plane = x >= 6 && x < 26 && y >= 6 && y < 26 && z >= 4 && z < 28;
        samples.push_back(in_plane && (z % 6 < 2 || z >= 22) ? 100.0F : 0.0F);
      }
  return samples;
}

TEST_F(GoodRun, ASmallFoldedScanIsLookedAtTwiceAsFineUnlessOptionsSayMore)
{
  const std::string plates = input("plates.nrrd", float_nrrd(samples_of_plates(32), "32 32 32"));
  const auto oversampling = [&](const std::string &arguments) {
    const Outcome outcome = run(arguments + " -q --report -");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return report_of(outcome)["options"]["oversampling"];
  };
  EXPECT_EQ(oversampling(plates), 2);
  for (const std::string option :
       {" --delta 20", " --regions 2", " --sigma 1", " --oversample 1", " --paper --delta 2"})
    EXPECT_EQ(oversampling(plates + option), 1) << option;
  EXPECT_EQ(oversampling(ball()), 1) << "no folds";
  const std::string large = input("large.nrrd", float_nrrd(samples_of_plates(102), "102 102 102"));
  EXPECT_EQ(oversampling(large), 1) << "a finer grid would be slow";
  const std::string thick = "space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,2)\n";
  EXPECT_EQ(oversampling(input("thick.nrrd", float_nrrd(samples_of_plates(32), "32 32 32", thick))), 1);
}

TEST_F(GoodRun, VerboseTellsOfTheGridThatAFoldedScanGets)
{
  const std::string plates = input("plates.nrrd", float_nrrd(samples_of_plates(32), "32 32 32"));
  EXPECT_TRUE(contains(run(plates + " -v").err,
                       "volume      63 x 63 x 63 samples of 0.5 x 0.5 x 0.5 mm, twice as fine as the scan\n"));
  EXPECT_TRUE(contains(run(plates + " -v --max-memory 80600000").err, "volume      32 x 32 x 32 samples"))
      << "memory would not do for it";
}

TEST_F(GoodRun, TellsItsVersionAndItsOptionsOnStandardOutput)
{
  const Outcome version = run("--version");
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out.rfind("volsurf ", 0), 0U);
  const Outcome help = run("--help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err + version.err, "");
  for (const std::string option :
       {"--delta",   "--sigma",  "--paper",      "--edge-map",   "--exterior",      "--keep",    "--rank-by",
        "--surface", "--seed",   "--smooth",     "--iterations", "--passband",      "--output",  "--frame",
        "--labels",  "--report", "--series",     "--threads",    "--quiet",         "--verbose", "--version",
        "--config",  "--region", "--min-volume", "--split",      "--save-hierarchy"})
    EXPECT_TRUE(contains(help.out, option));
}

TEST_F(GoodRun, ConfigFileHoldsOptionsAndTheCommandLineWins)
{
  const std::string config = input("o.ini", "# comments\ndelta = 2\nseed = 8,8,8\nkeep = 100%\nsmooth = 0\n"
                                            "output = my ball.obj\noutput = ball.stl\nquiet = true\n");
  const Outcome from_file = run(ball() + " --config " + config);
  EXPECT_EQ(from_file.exit_code, 0) << from_file.err;
  EXPECT_EQ(from_file.err, "");
  EXPECT_EQ(files(), (std::set<std::string>{"my ball.obj", "ball.stl"}));
  const auto options = report(ball() + " --config " + config + " --delta 3 --output other.obj")["options"];
  EXPECT_EQ(options["delta"], 3);
  EXPECT_EQ(options["keep"], "100%");
  EXPECT_EQ(options["outputs"], nlohmann::json({"other.obj"}));
  EXPECT_EQ(options["seeds_mm"], nlohmann::json({{8, 8, 8}}));
}

TEST_F(GoodRun, FrameRasTurnsXAndY)
{
  expect_done(ball() + " --delta 2 -o lps.obj");
  expect_done(ball() + " --delta 2 -o ras.obj --frame ras");
  auto points = vertices(read_file(work / "lps.obj"));
  ASSERT_FALSE(points.empty());
  for (auto &point : points)
    point = {0 - point[0], 0 - point[1], point[2]};
  EXPECT_EQ(points, vertices(read_file(work / "ras.obj")));
  EXPECT_TRUE(contains(read_file(work / "ras.obj"), "SPACE=RAS"));
}

TEST_F(GoodRun, SeedAndItsRasPositionGiveTheSameWatertightSurface)
{
  const auto lps = report(ball() + " --delta 2 --seed 8,8,8")["mesh"];
  const auto ras = report(ball() + " --delta 2 --seed -8,-8,8 --frame ras")["mesh"];
  EXPECT_EQ(lps["watertight"], true);
  EXPECT_EQ(lps["shells"], 1);
  EXPECT_EQ(lps["genus"], 0);
  EXPECT_EQ(lps, ras);
}

TEST_F(GoodRun, HullIsWatertightAndItsVolumePositive)
{
  const auto mesh = report(head(48) + " --delta 15 --surface hull")["mesh"];
  EXPECT_EQ(mesh["watertight"], true);
  EXPECT_GT(mesh["volume_mm3"], 1e6);
  EXPECT_EQ(mesh["open_edges"], 0);
  EXPECT_EQ(mesh["non_manifold_edges"], 0);
  EXPECT_EQ(mesh["misoriented_edges"], 0);
}

TEST_F(GoodRun, MirroredDirectionsKeepNormalsOutward)
{
  const std::string mirrored = "space: left-posterior-superior\nspace directions: (-1,0,0) (0,1,0) (0,0,1)\n";
  const auto plain = report(ball() + " --delta 2 --surface hull")["mesh"];
  const auto turned =
      report(input("m.nrrd", float_nrrd(ball_samples(), kBallSizes, mirrored)) + " --delta 2 --surface hull")["mesh"];
  EXPECT_GT(plain["volume_mm3"], 0);
  EXPECT_NEAR(turned["volume_mm3"].get<double>(), plain["volume_mm3"].get<double>(), 1e-2);
  EXPECT_EQ(turned["triangles"], plain["triangles"]);
}

TEST_F(GoodRun, KeepTakesTheLargestComponents)
{
  const std::string scan = balls() + " --delta 2 --sigma 0";
  const auto all = report(scan + " --keep all");
  EXPECT_EQ(all["counts"]["components"], 27);
  EXPECT_EQ(all["counts"]["components_kept"], 27);
  EXPECT_EQ(all["mesh"]["shells"], 27);
  const auto percent = report(scan + " --keep 5%");
  EXPECT_EQ(percent["counts"]["components_kept"], 2) << "the ceiling of 1.35";
  EXPECT_EQ(percent["mesh"]["shells"], 2);
  const auto one = report(scan + " --keep 1");
  EXPECT_EQ(one["mesh"]["shells"], 1);
  EXPECT_EQ(one["component_sizes"][0], all["component_sizes"][0]);
  EXPECT_EQ(report(scan + " --keep 1000000")["mesh"], all["mesh"]);
}

TEST_F(GoodRun, RankBySaysWhatALargeComponentIs)
{
  const std::string scan = balls() + " --delta 2 --sigma 0 --smooth 0 --keep 1 --rank-by ";
  const auto faces = report(scan + "faces");
  EXPECT_EQ(faces["component_sizes"][0].get<int>() * 2, faces["mesh"]["triangles"].get<int>());
  const auto area = report(scan + "area");
  const double area_mm2 = area["mesh"]["area_mm2"];
  EXPECT_NEAR(area["component_sizes"][0].get<double>(), area_mm2, 1e-4 * area_mm2);
  const auto radius = report(scan + "radius");
  double squares = 0;
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent =
        radius["mesh"]["bounds_high_mm"][axis].get<double>() - radius["mesh"]["bounds_low_mm"][axis].get<double>();
    squares += extent * extent;
    longest = std::max(longest, extent);
  }
  EXPECT_GE(radius["component_sizes"][0].get<double>(), longest / 2 - 1e-3);
  EXPECT_LE(radius["component_sizes"][0].get<double>(), std::sqrt(squares));
}

TEST_F(GoodRun, InfiniteExteriorDrainsWhatTheBorderCuts)
{
  const std::string cut = input("cut.nrrd", float_nrrd(ball_samples({8.5, 8.5, 0})));
  EXPECT_EQ(report(cut + " --delta 2")["counts"]["regions"], 2);
  expect_refused(cut + " --delta 2 --exterior infinite -o other.vtp", 4, {"no boundary survives delta = 2"});
}

TEST_F(GoodRun, PaperIsSigmaZeroInfiniteExteriorAndNoSnap)
{
  const std::string scan = head(32) + " --delta 20";
  expect_done(scan + " --paper -o paper.vtp");
  expect_done(scan + " --sigma 0 --exterior infinite --snap off -o same.vtp");
  EXPECT_EQ(read_file(work / "paper.vtp"), read_file(work / "same.vtp"));
}

TEST_F(GoodRun, SnapMovesPointsUnlessThereIsNothingToPlaceThemBy)
{
  const auto snap = [&](const std::string &options) { return report(ball() + " --delta 2 " + options)["snap"]; };
  const nlohmann::json placed = snap("");
  ASSERT_FALSE(placed.is_null());
  EXPECT_GT(placed["moved"], 100);
  EXPECT_GT(placed["root_mean_square_mm"], 0);
  EXPECT_LT(placed["root_mean_square_mm"], 1.5);
  for (const std::string options : {"--snap off", "--smooth 0", "--paper"})
    EXPECT_TRUE(snap(options).is_null()) << options;
  EXPECT_TRUE(report(head(32) + " --edge-map --delta 10")["snap"].is_null());
}

TEST_F(GoodRun, EdgeMapOfTheGradientMagnitudeGivesTheSameSurface)
{
  const std::string magnitude = input("magnitude.nrrd", float_nrrd(ball_gradient_magnitude()));
  expect_done(ball() + " --delta 2 --sigma 0 --snap off -o scan.obj --labels scan.nrrd");
  expect_done(magnitude + " --delta 2 --edge-map -o map.obj --labels map.nrrd");
  const std::string surface = without_comments(read_file(work / "scan.obj"));
  EXPECT_FALSE(surface.empty());
  EXPECT_EQ(surface, without_comments(read_file(work / "map.obj")));
  EXPECT_EQ(after_header(read_file(work / "scan.nrrd")), after_header(read_file(work / "map.nrrd")));
}

TEST_F(GoodRun, ProgressIsDrawnOnATerminalOnlyAndInColourUnlessToldNot)
{
  const std::string plain = run(ball() + " --delta 2").err;
  EXPECT_EQ(plain.find_first_of("\r\033"), std::string::npos) << plain;
  if (!has_program("script"))
    GTEST_SKIP() << "script (bsdutils), which makes a terminal, is missing";
  const std::string command = "script -qec \"'" VOLSURF "' " + ball() + " --delta 2\" /dev/null";
  EXPECT_TRUE(contains(run_program(work.path(), "env -u NO_COLOR " + command).out, "\033[36m"));
  const std::string colourless = run_program(work.path(), "env NO_COLOR=1 " + command).out;
  EXPECT_TRUE(contains(colourless, "\rread "));
  EXPECT_EQ(colourless.find('\033'), std::string::npos);
}

TEST_F(GoodRun, ShippedBrainGivesASurface)
{
  const auto brain = report(VOLSURF_SOURCE "/data/brain.nrrd --delta 20 --keep 5%");
  EXPECT_GT(brain["mesh"]["triangles"], 10000);
  EXPECT_EQ(brain["geometry"]["size"], nlohmann::json({128, 128, 128}));
  EXPECT_EQ(files(), std::set<std::string>{"brain.vtp"});
}

} // namespace
} // namespace volsurf::test
