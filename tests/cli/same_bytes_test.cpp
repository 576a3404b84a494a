// Equal input and options make equal files, whatever the number of threads and however often.
#include "cli/volsurf_program.h"

namespace volsurf::test {
namespace {

class SameBytes : public VolsurfProgram {
protected:
  void expect_for(const std::string &options) const
  {
    const std::string scan = head(48);
    std::string first;
    for (const std::string threads : {"1", "2", "3", "3"}) {
      const Outcome outcome = run(scan + " --threads " + threads + " " + options +
                                  " -o a.vtp -o a.stl -o a.ply -o a.obj -o a.vdb --save-hierarchy a.volsurf" +
                                  (options.find("--labels") == std::string::npos ? " --labels a.nrrd" : ""));
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      std::string all;
      for (const std::string &name : files())
        all += name + "\n" + read_file(work / name);
      EXPECT_TRUE(first.empty() || first == all) << options << " with " << threads << " threads";
      first = all;
    }
  }
};

TEST_F(SameBytes, ForTheSurfacesBetweenAllRegions)
{
  expect_for("--delta 5 --keep 50%");
}

TEST_F(SameBytes, ForTheHull)
{
  expect_for("--delta 15 --surface hull --rank-by area");
}

TEST_F(SameBytes, ForSeeds)
{
  expect_for("--delta 15 --seed 35,0,30 --seed -35,0,30 --smooth 1");
}

TEST_F(SameBytes, ForTheInfiniteExterior)
{
  expect_for("--delta 10 --exterior infinite --rank-by radius --keep 3");
}

TEST_F(SameBytes, WithoutAGaussian)
{
  expect_for("--delta 20 --sigma 0 --smooth 0 --frame ras");
}

TEST_F(SameBytes, OfMedians)
{
  expect_for("--delta 15 --median 1");
  expect_for("--delta 15 --oversample 2");
}

TEST_F(SameBytes, ForEachRegionInAFileOfItsOwn)
{
  expect_for("--delta 10 --split regions --min-volume 3000");
}

TEST_F(SameBytes, ForEachComponentInAFileOfItsOwn)
{
  expect_for("--delta 10 --split components --keep 3 --labels b.seg.nrrd");
}

} // namespace
} // namespace volsurf::test
