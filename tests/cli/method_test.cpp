// The usual methods beside volsurf's own: the same scan, selection, outputs and report.
#include "cli/report_of.h"
#include "cli/volsurf_program.h"

namespace volsurf::test {
namespace {

using nlohmann::json;

constexpr double kPi = 3.14159265358979;

class UsualMethod : public VolsurfProgram {
protected:
  json report(const std::string &arguments) const
  {
    const Outcome outcome = run(arguments + " -q --report -");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << ": " << outcome.err;
    return report_of(outcome);
  }

  /// Where the ball has 50: its wall is linear, so the radius is 5 mm.
  void expect_ball(const std::string &method, double tolerance) const
  {
    const json found = report(ball() + " " + method);
    EXPECT_TRUE(found["mesh"]["watertight"]) << method;
    EXPECT_EQ(found["counts"]["components"], 1) << method;
    const double volume = found["mesh"]["volume_mm3"];
    EXPECT_NEAR(volume / (4.0 / 3.0 * kPi * 125), 1, tolerance) << method;
    EXPECT_NEAR(found["mesh"]["bounds_low_mm"][0], 3.5, 0.6) << method;
    EXPECT_NEAR(found["mesh"]["bounds_high_mm"][2], 13.5, 0.6) << method;
  }

  void expect_refused_by(const std::string &method, const std::vector<std::string> &options) const
  {
    const std::string run = ball() + " --method " + method + " ";
    for (const std::string &option : options)
      expect_refused(run + option, 2,
                     {"--method " + method + ": found " + option.substr(0, option.find(' ')), "means nothing"});
  }

  /// The same bytes of all outputs for any number of threads.
  void expect_same_bytes(const std::string &options) const
  {
    const std::string job = head(32) + " -o a.vtp -o a.stl -o a.obj " + options;
    std::string first;
    for (const std::string threads : {" --threads 1", " --threads 3"}) {
      const Outcome outcome = run(job + threads);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      std::string all;
      for (const std::string &name : files())
        all += name + "\n" + read_file(work / name);
      EXPECT_TRUE(first.empty() || first == all) << options;
      first = all;
    }
  }
};

const std::vector<std::string> kIsosurfaces{"isosurface", "marching-cubes"};

TEST_F(UsualMethod, FindsTheBall)
{
  expect_ball("--method threshold --iso 50", 0.1);
  expect_ball("--method isosurface --iso 50", 0.05);
  expect_ball("--method marching-cubes --iso 50", 0.05);
  expect_ball("--method watershed --delta 10 --surface hull", 0.25);
}

TEST_F(UsualMethod, TakesOtsusValueWithoutAnother)
{
  for (const std::string method : {"threshold", "isosurface"}) {
    const json found = report(ball() + " --method " + method);
    const double iso = found["options"]["iso"];
    EXPECT_GT(iso, 20) << method;
    EXPECT_LT(iso, 80) << method;
    EXPECT_EQ(report(ball() + " --method " + method + " --iso otsu")["mesh"], found["mesh"]) << method;
  }
}

TEST_F(UsualMethod, OfAThresholdHasTheVoxelsThatAreAtLeastTheIsoValue)
{
  const json found = report(ball() + " --method threshold --iso 50 --smooth 0 --labels l.nrrd");
  const auto samples = ball_samples();
  const auto inside = std::count_if(samples.begin(), samples.end(), [](float sample) { return sample >= 50; });
  EXPECT_NEAR(found["mesh"]["volume_mm3"], static_cast<double>(inside), 1e-3);
  EXPECT_EQ(found["counts"]["regions"], 2);
  const std::string labels = read_file(work / "l.nrrd");
  EXPECT_TRUE(contains(labels, "\nsizes: 18 18 18\n")) << "the scan's own grid";
  EXPECT_TRUE(contains(labels, "\nspace origin: (0,0,0)\n"));
}

TEST_F(UsualMethod, OfAWatershedHasAsManyRegionsAsVolsurf)
{
  const std::string scan = head(32) + " ";
  for (const std::string options : {"--delta 5", "--delta 12", "--delta 10 --sigma 0", "--delta 12.5 --edge-map"})
    EXPECT_EQ(report(scan + options + " --method watershed")["counts"]["regions"],
              report(scan + options)["counts"]["regions"])
        << options;
}

TEST_F(UsualMethod, OfAnIsosurfaceIsNotSmoothedUnlessAskedFor)
{
  for (const std::string &method : kIsosurfaces) {
    const std::string run = balls() + " --method " + method + " --iso 50";
    EXPECT_EQ(report(run)["options"]["iterations"], 0);
    EXPECT_GT(report(run + " --smooth 0.5")["options"]["iterations"], 0);
    EXPECT_EQ(report(run + " --iterations 15")["options"]["iterations"], 15);
  }
  EXPECT_GT(report(ball() + " --method threshold --iso 50")["options"]["iterations"], 0);
}

TEST_F(UsualMethod, KeepsAndSplitsComponentsByRank)
{
  for (const std::string method : {"threshold", "isosurface", "marching-cubes"}) {
    const std::string run = balls() + " --method " + method + " --iso 50 -o a.stl";
    const json kept = report(run + " --keep 2 --rank-by area");
    EXPECT_EQ(kept["counts"]["components"], 27) << method;
    EXPECT_EQ(kept["counts"]["components_kept"], 2) << method;
    EXPECT_EQ(kept["mesh"]["shells"], 2) << method;
    const json split = report(run + " --keep 3 --split components");
    EXPECT_EQ(split["surfaces"].size(), 3U) << method;
    EXPECT_TRUE(std::filesystem::exists(work / "a_component_3.stl"));
  }
}

TEST_F(UsualMethod, TakesMediansAndSavedHierarchiesToo)
{
  auto samples = ball_samples();
  samples[100] = 1000;
  const std::string noisy = input("noisy.nrrd", float_nrrd(samples)) + " --method threshold --iso 50";
  EXPECT_EQ(report(noisy)["counts"]["components"], 2);
  EXPECT_EQ(report(noisy + " --median 1")["counts"]["components"], 1);
  EXPECT_EQ(run(ball() + " --delta 2 --save-hierarchy ball.volsurf").exit_code, 0);
  for (const std::string method : {"threshold", "isosurface", "watershed --delta 10"})
    EXPECT_EQ(report("ball.volsurf --method " + method)["mesh"], report(ball() + " --method " + method)["mesh"]);
}

TEST_F(UsualMethod, IsNamedInWhatItWrites)
{
  EXPECT_EQ(report(ball() + " --method threshold --iso 50 --median 1 --keep 1")["options"]["command_line"],
            "--method threshold --iso 50 --median 1 --keep 1 --rank-by faces --smooth 0.5 --frame lps");
  EXPECT_EQ(report(ball() + " --method watershed --delta 10")["options"]["command_line"],
            "--method watershed --delta 10 --keep all --rank-by faces --smooth 0.5 --frame lps");
  const std::string printed = run(ball() + " --method isosurface --iso 50").err;
  EXPECT_TRUE(contains(printed, "at the iso-value 50, watertight"));
  EXPECT_TRUE(
      contains(run(ball() + " --method threshold --iso 50 -v").err, "method      threshold, at the iso-value 50"));
}

TEST_F(UsualMethod, RefusesWhatMeansNothingToIt)
{
  expect_refused_by("volsurf", {"--iso 50", "--iso otsu"});
  expect_refused_by("watershed", {"--iso 50 --delta 2", "--paper --delta 2", "--snap on --delta 2",
                                  "--exterior none --delta 2", "--save-hierarchy a.volsurf --delta 2"});
  expect_refused_by("threshold", {"--delta 2", "--delta auto", "--regions 3", "--sigma 1", "--edge-map", "--snap on",
                                  "--exterior none", "--save-hierarchy a.volsurf"});
  for (const std::string &method : kIsosurfaces)
    expect_refused_by(
        method, {"--delta 2", "--seed 8,8,8", "--region 2", "--min-volume 5", "--split regions", "--labels l.nrrd"});
  expect_refused(ball() + " --method isosurface -o a.vdb", 2, {"--method isosurface: found a .vdb"});
  for (const std::string delta : {"", "--delta auto", "--delta 5%", "--regions 3"})
    expect_refused(ball() + " --method watershed " + delta, 2,
                   {"--method watershed: found --", "--delta with a number"});
}

TEST_F(UsualMethod, RefusesWordsAndNumbersOutOfRange)
{
  expect_refused(ball() + " --method kmeans", 2, {"--method: found \"kmeans\"; allowed are volsurf, threshold"});
  for (const std::string iso : {"text", "nan", "inf", "5x"})
    expect_refused(ball() + " --method threshold --iso " + iso, 2, {"--iso: found", "allowed are otsu and finite"});
}

TEST_F(UsualMethod, SaysWhereThereIsNoSurface)
{
  for (const std::string method : {"threshold", "isosurface", "marching-cubes"}) {
    const std::string run = ball() + " --method " + method + " --iso=";
    for (const std::string iso : {"-5", "500"})
      expect_refused(run + iso, 4,
                     {"ball.nrrd: --method " + method + " finds no surface", "from 0 to 100", "iso-value is " + iso});
  }
  expect_refused(ball() + " --method watershed --delta 1e6", 4, {"finds no surface", "one region at --delta 1000000"});
}

TEST_F(UsualMethod, MakesTheSameBytesForAnyNumberOfThreads)
{
  expect_same_bytes("--method threshold --labels l.nrrd -o a.vdb");
  expect_same_bytes("--method isosurface");
  expect_same_bytes("--method marching-cubes --smooth 0.5");
  expect_same_bytes("--method watershed --delta 10 --labels l.seg.nrrd --split regions --min-volume 3000");
}

} // namespace
} // namespace volsurf::test
