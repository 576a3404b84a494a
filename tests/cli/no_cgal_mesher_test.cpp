// --method cgal-mesher of a program that is built without CGAL.
#include "cli/volsurf_program.h"

namespace volsurf::test {
namespace {

using NoCgalMesher = VolsurfProgram;

TEST_F(NoCgalMesher, IsAUsageErrorThatSaysHowToGetIt)
{
  expect_refused(ball() + " --method cgal-mesher --iso 50", 2,
                 {"--method cgal-mesher: found a program built without CGAL", "libcgal-dev", "-DVOLSURF_WITH_CGAL=ON"});
}

TEST_F(NoCgalMesher, IsSaidByTheHelp)
{
  const std::string help = run("--help").out;
  EXPECT_TRUE(contains(help, "built without CGAL"));
  EXPECT_FALSE(contains(help, "with CGAL)"));
}

} // namespace
} // namespace volsurf::test
