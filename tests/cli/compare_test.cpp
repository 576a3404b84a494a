// The program volsurf-compare. VOLSURF_COMPARE is its path.
#include "cli/report_of.h"
#include "cli/volsurf_program.h"

namespace volsurf::test {
namespace {

using nlohmann::json;

/// A unit cube of four-sided faces from (0, 0, 0) to (s, s, s).
std::string cube_obj(double size, const std::string &header = "# SPACE=LPS\n")
{
  std::string text = header;
  for (int i = 0; i < 8; ++i) {
    text += "v";
    for (const int bit : {1, 2, 4})
      text += " " + std::to_string((i & bit) != 0 ? size : 0.0);
    text += "\n";
  }
  return text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
}

class CompareProgram : public VolsurfProgram {
protected:
  CompareProgram()
  {
    input("two.obj", cube_obj(2));
    input("four.obj", cube_obj(4));
    input("labels.nrrd",
          float_nrrd({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "3 3 3"));
  }

  std::string path(const std::string &name) const { return (inputs / name).string(); }

  Outcome compare(const std::string &arguments) const
  {
    return run_program(work.path(), "'" VOLSURF_COMPARE "' " + arguments);
  }

  void expect_message(const std::string &arguments, int exit_code, const std::vector<std::string> &parts) const
  {
    const Outcome outcome = compare(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << arguments << ": " << outcome.err;
    EXPECT_TRUE(is_one_line(outcome.err)) << arguments << ": " << outcome.err;
    EXPECT_EQ(outcome.err.rfind("volsurf-compare: ", 0), 0U) << outcome.err;
    for (const std::string &part : parts)
      EXPECT_TRUE(contains(outcome.err, part)) << arguments;
    EXPECT_EQ(file_count(work.path()), 0) << arguments;
  }
};

TEST_F(CompareProgram, PrintsATableAndNothingElse)
{
  const Outcome outcome = compare(path("two.obj") + " " + path("four.obj"));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const std::string word :
       {"A  ", "12 triangles, closed, LPS", "assd", "hd95", "hausdorff", "surface_dice", "dice"})
    EXPECT_TRUE(contains(outcome.out, word));
  EXPECT_EQ(compare("-q " + path("two.obj") + " " + path("four.obj")).out, "");
}

TEST_F(CompareProgram, JsonHoldsTheMetrics)
{
  const json report = report_of(compare(path("two.obj") + " " + path("four.obj") + " --spacing 0.25 --json -"));
  const json &found = report["metrics"];
  EXPECT_NEAR(found["volume_a"], 8, 1e-9);
  EXPECT_NEAR(found["volume_b"], 64, 1e-9);
  EXPECT_NEAR(found["volume_error"], -56.0 / 64, 1e-9);
  EXPECT_EQ(found["dice"], 16.0 / 72);
  EXPECT_EQ(found["jaccard"], 8.0 / 64);
  EXPECT_NEAR(found["hausdorff"], std::sqrt(12.0), 1e-6);
  EXPECT_NEAR(found["max_a_to_b"], 2, 1e-6);
  EXPECT_EQ(compare(path("two.obj") + " " + path("four.obj") + " --spacing 0.25 --json r.json").exit_code, 0);
  EXPECT_EQ(json::parse(read_file(work / "r.json")), report);
}

TEST_F(CompareProgram, JsonIsValidBySchema)
{
  if (run_program(work.path(), "/usr/bin/python3 -c 'import jsonschema'").exit_code != 0)
    GTEST_SKIP() << "python3-jsonschema is missing: scripts/install_packages.sh --test installs it";
  input("open.obj", cube_obj(2).substr(0, cube_obj(2).rfind("f ")));
  for (const std::string files : {"two.obj four.obj", "two.obj two.obj", "open.obj two.obj", "two.obj labels.nrrd"}) {
    const auto blank = files.find(' ');
    const Outcome outcome =
        compare(path(files.substr(0, blank)) + " " + path(files.substr(blank + 1)) + " --require 'dice>=0.1' --json -");
    write_file(inputs / "report.json", outcome.out);
    const Outcome check = run_program(
        inputs.path(), "/usr/bin/python3 -c 'import json, sys; from jsonschema import Draft202012Validator as V; "
                       "V(json.load(open(sys.argv[1]))).validate(json.load(open(sys.argv[2])))' '" VOLSURF_SOURCE
                       "/docs/comparison.schema.json' report.json");
    EXPECT_EQ(check.exit_code, 0) << files << check.err;
  }
}

TEST_F(CompareProgram, DistanceWritesAWithItsDistances)
{
  EXPECT_EQ(compare(path("two.obj") + " " + path("four.obj") + " --distance d.vtp").exit_code, 0);
  const std::string text = read_file(work / "d.vtp");
  EXPECT_TRUE(contains(text, "SignedDistance"));
  EXPECT_TRUE(contains(text, "DistanceToB"));
  EXPECT_EQ(compare("d.vtp " + path("two.obj") + " --require 'hausdorff<=0.000001'").exit_code, 0);
}

TEST_F(CompareProgram, LabelsChooseWhatCounts)
{
  const auto voxels = [&](const std::string &options) {
    return report_of(compare(path("labels.nrrd") + " " + path("labels.nrrd") + options + " --json -"))["a"]["voxels"];
  };
  EXPECT_EQ(voxels(""), 2);
  EXPECT_EQ(voxels(" --label 1"), 1);
  EXPECT_EQ(voxels(" --label 1 --label 2"), 2);
}

TEST_F(CompareProgram, RequirementsDecideTheExitCode)
{
  const std::string files = path("two.obj") + " " + path("four.obj");
  EXPECT_EQ(compare(files + " --require 'dice<0.5' --require 'assd > 0.1'").exit_code, 0);
  const Outcome outcome = compare(files + " --require 'dice>=0.95' --json r.json");
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_TRUE(contains(outcome.err, "volsurf-compare: --require dice>=0.95 is not met: dice is 0.22"));
  EXPECT_TRUE(contains(outcome.out, "dice")) << "the results are there all the same";
  EXPECT_EQ(json::parse(read_file(work / "r.json"))["requirements"][0]["met"], false);
}

TEST_F(CompareProgram, SaysWhichFrameItAssumes)
{
  const std::string unmarked = input("unmarked.obj", cube_obj(2, ""));
  EXPECT_TRUE(contains(compare(unmarked + " " + path("two.obj")).out, "LPS (assumed, the file names no frame)"));
  const Outcome apart = compare(unmarked + " " + input("far.obj", cube_obj(-2)) + " --frame ras --require 'dice>0.9'");
  EXPECT_EQ(apart.exit_code, 5) << "a half turn about z keeps z";
  const std::string marked = input("ras.obj", cube_obj(2, "# SPACE=RAS\n"));
  EXPECT_EQ(compare(unmarked + " " + marked + " --frame ras --require 'hausdorff<=1e-9'").exit_code, 0);
}

TEST_F(CompareProgram, SameBytesForAnyNumberOfThreads)
{
  const std::string files = path("four.obj") + " " + path("labels.nrrd") + " --json -";
  EXPECT_EQ(compare(files + " --threads 1").out, compare(files + " --threads 3").out);
}

TEST_F(CompareProgram, AnswersBadInputInOneLine)
{
  const std::string good = path("two.obj");
  expect_message("gone.vtp " + good, 3, {"gone.vtp: the file does not exist"});
  expect_message(good + " gone.nrrd", 3, {"gone.nrrd: the file does not exist"});
  expect_message(good + " " + input("none.obj", "v 0 0 0\n"), 3, {"none.obj: found no triangle"});
  expect_message(good + " " + input("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), 3,
                 {"flat.obj: found no triangle with an area"});
  expect_message(good + " " + input("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), 3, {"not finite"});
  expect_message(good + " " + input("frame.obj", cube_obj(2, "# SPACE=ABC\n")), 3, {"SPACE=ABC; allowed: LPS, RAS"});
  expect_message(good + " " + path("labels.nrrd") + " --label 9", 3, {"labels.nrrd: found no sample with label 9"});
  expect_message(good + " " + path("four.obj") + " --spacing 1e-6", 3, {"--spacing"});
}

TEST_F(CompareProgram, AnswersBadUsageInOneLine)
{
  const std::string files = path("two.obj") + " " + path("four.obj");
  expect_message(path("two.obj"), 2, {"B is required"});
  expect_message(files + " --bogus", 2, {"--bogus"});
  expect_message(files + " --tolerance -1", 2, {"--tolerance: found -1"});
  expect_message(files + " --tolerance nan", 2, {"--tolerance: found nan"});
  expect_message(files + " --spacing 0", 2, {"--spacing: found 0; allowed are finite numbers above 0"});
  expect_message(files + " --samples 0", 2, {"--samples: found 0"});
  expect_message(files + " --frame xyz", 2, {"--frame: found \"xyz\"; allowed are lps, ras"});
  expect_message(files + " --label 1", 2, {"--label: A and B are surfaces"});
  expect_message(files + " --require 'dise>0.5'", 2, {"the metric \"dise\"; allowed are assd, rms,"});
  expect_message(files + " --require dice", 2, {"--require: found \"dice\""});
  expect_message(files + " --json ''", 2, {"--json: found \"\""});
  expect_message(files + " --distance d.stl", 2, {"d.stl"});
  expect_message(files + " --json " + path("two.obj"), 2, {"named twice"});
}

TEST_F(CompareProgram, SaysWhereItCannotWriteBeforeTheWork)
{
  const std::string files = "gone.vtp " + path("four.obj");
  expect_message(files + " --json missing/r.json", 5, {"missing/r.json: the folder missing does not exist"});
  expect_message(files + " --distance missing/d.vtp", 5, {"missing/d.vtp"});
}

TEST_F(CompareProgram, WarnsOfAnOpenSurface)
{
  const std::string text = cube_obj(2);
  expect_message("-q " + input("open.obj", text.substr(0, text.rfind("f "))) + " " + path("two.obj") +
                     " --require 'dice>=0'",
                 5, {"dice has no value"});
  const Outcome outcome = compare(path("open.obj") + " " + path("two.obj"));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(contains(outcome.err, "warning: A is not closed (4 edges"));
}

/// Dice as another program counts it, on the same labels.
TEST_F(CompareProgram, AgreesWithPlastimatch)
{
  if (!has_program("plastimatch"))
    GTEST_SKIP() << "plastimatch is missing: apt-get install plastimatch";
  const auto ball = [&](const std::string &name, double x) {
    std::string bytes;
    for (const float sample : ball_samples({x, 8.5, 8.5}))
      bytes += sample > 50 ? '\1' : '\0';
    return input(name, nrrd_header("uint8", kBallSizes, "encoding: raw\n") + "\n" + bytes);
  };
  const std::string files = ball("a.nrrd", 8.5) + " " + ball("b.nrrd", 10);
  const Outcome theirs = run_program(work.path(), "plastimatch dice --dice " + files);
  const auto at = theirs.out.find("DICE:");
  ASSERT_NE(at, std::string::npos) << theirs.out << theirs.err;
  const double dice = report_of(compare(files + " --json -"))["metrics"]["dice"];
  EXPECT_NEAR(dice, std::stod(theirs.out.substr(at + 5)), 1e-5);
}

} // namespace
} // namespace volsurf::test
