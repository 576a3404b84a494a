// OpenVDB's own program as a witness of the .vdb files.
#include "cli/volsurf_program.h"

namespace volsurf::test {
namespace {

class VdbPrint : public VolsurfProgram {
protected:
  void SetUp() override
  {
    if (!has_program("vdb_print"))
      GTEST_SKIP() << "vdb_print is missing: scripts/install_packages.sh --test installs libopenvdb-tools";
  }

  std::string printed(const std::string &options) const { return run_program(work.path(), "vdb_print " + options).out; }
};

TEST_F(VdbPrint, ListsBothGridsWithTheirSizesAndTypes)
{
  ASSERT_EQ(run(ball() + " --delta 2 -o out.vdb").exit_code, 0);
  const std::string list = printed("out.vdb");
  EXPECT_TRUE(contains(list, "gradient_magnitude"));
  EXPECT_TRUE(contains(list, "18x18x18"));
  EXPECT_TRUE(contains(list, "regions"));
  EXPECT_TRUE(contains(list, "17x17x17"));
  const std::string details = printed("-l out.vdb");
  EXPECT_TRUE(contains(details, "Tree_float_5_4_3"));
  EXPECT_TRUE(contains(details, "Tree_int32_5_4_3"));
  EXPECT_TRUE(contains(details, "Min value: 1\n  Max value: 2\n")) << "two regions";
}

TEST_F(VdbPrint, FindsProvenanceAndPlaceInBothGrids)
{
  const std::string place =
      "space: left-posterior-superior\nspace origin: (10,20,30)\nspace directions: (1,0,0) (0,2,0) "
      "(0,0,4)\n";
  const std::string scan = input("placed.nrrd", float_nrrd(ball_samples(), kBallSizes, place));
  ASSERT_EQ(run(scan + " --delta 2 -o out.vdb --frame ras").exit_code, 0);
  const std::string details = printed("-l out.vdb");
  const auto regions = details.find("Name: regions");
  ASSERT_NE(regions, std::string::npos);
  for (const std::string &grid : {details.substr(0, regions), details.substr(regions)}) {
    EXPECT_TRUE(contains(grid, "SPACE: RAS\n"));
    EXPECT_TRUE(contains(grid, "Source: placed.nrrd\n"));
    EXPECT_TRUE(contains(grid, "Version: volsurf "));
    EXPECT_TRUE(contains(grid, "Options: --delta 2 "));
    EXPECT_TRUE(contains(grid, "[-1, 0, 0, 0]"));
    EXPECT_TRUE(contains(grid, "[0, -2, 0, 0]"));
    EXPECT_TRUE(contains(grid, "[0, 0, 4, 0]"));
  }
  EXPECT_TRUE(contains(details.substr(0, regions), "[-10, -20, 30, 1]"));
  EXPECT_TRUE(contains(details.substr(regions), "[-10.5, -21, 32, 1]")) << "half a voxel further";
}

} // namespace
} // namespace volsurf::test
