// --method cgal-mesher of a program that is built with CGAL.
#include "cli/report_of.h"
#include "cli/volsurf_program.h"

namespace volsurf::test {
namespace {

using CgalMesherOption = VolsurfProgram;

const std::string kMethod = " --method cgal-mesher --iso 50 ";

TEST_F(CgalMesherOption, FindsTheBall)
{
  const Outcome outcome = run(ball() + kMethod + "-q --report -");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const nlohmann::json found = report_of(outcome);
  EXPECT_TRUE(found["mesh"]["watertight"]);
  EXPECT_EQ(found["counts"]["components"], 1);
  const double volume = found["mesh"]["volume_mm3"];
  EXPECT_NEAR(volume / (4.0 / 3.0 * 3.14159265358979 * 125), 1, 0.05);
  EXPECT_EQ(found["options"]["command_line"],
            "--method cgal-mesher --iso 50 --keep all --rank-by faces --smooth 0 --frame lps");
}

TEST_F(CgalMesherOption, KeepsComponentsByRank)
{
  const nlohmann::json found = report_of(run(balls() + kMethod + "--keep 2 -q --report -"));
  EXPECT_EQ(found["counts"]["components"], 27);
  EXPECT_EQ(found["mesh"]["shells"], 2);
}

TEST_F(CgalMesherOption, MakesTheSameBytesInEachRun)
{
  const std::string job = head(32) + kMethod + "-o a.stl --threads ";
  ASSERT_EQ(run(job + "1").exit_code, 0);
  const std::string first = read_file(work / "a.stl");
  ASSERT_EQ(run(job + "3").exit_code, 0);
  EXPECT_EQ(read_file(work / "a.stl"), first);
}

TEST_F(CgalMesherOption, RefusesWhatMeansNothingToIt)
{
  for (const std::string option : {"--delta 2", "--seed 8,8,8", "--labels l.nrrd"})
    expect_refused(ball() + " --method cgal-mesher " + option, 2, {"--method cgal-mesher: found --", "means nothing"});
}

TEST_F(CgalMesherOption, SaysWhereThereIsNoSurface)
{
  for (const std::string iso : {"-5", "500"})
    expect_refused(ball() + " --method cgal-mesher --iso=" + iso, 4,
                   {"ball.nrrd: --method cgal-mesher finds no surface", "iso-value is " + iso});
}

TEST_F(CgalMesherOption, IsNamedInTheHelp)
{
  EXPECT_TRUE(contains(run("--help").out, "(with CGAL)"));
}

} // namespace
} // namespace volsurf::test
