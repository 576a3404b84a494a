// Cuts of a saved hierarchy are cuts of the scan.
#include "cli/report_of.h"
#include "cli/volsurf_program.h"

namespace volsurf::test {
namespace {

using nlohmann::json;

class SavedHierarchy : public VolsurfProgram {
protected:
  void save(const std::string &scan_and_options) const
  {
    const Outcome outcome = run(scan_and_options + " --save-hierarchy scan.volsurf");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  /// All outputs of a run, and what is left of its report without times, paths and memory.
  std::string results(const std::string &arguments) const
  {
    const Outcome outcome = run(arguments + " -o a.vtp -o a.stl -o a.vdb --labels a.nrrd --report -");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << ": " << outcome.err;
    json report = report_of(outcome);
    for (const std::string pointer : {"/source/path", "/source/hierarchy", "/seconds", "/peak_memory_bytes"})
      report[json::json_pointer(pointer)] = nullptr;
    std::string all = report.dump();
    for (const std::string name : {"a.vtp", "a.stl", "a.vdb", "a.nrrd"})
      all += read_file(work / name);
    return all;
  }

  void expect_cuts_as(const std::string &scan, const std::string &merge_options,
                      const std::vector<std::string> &cut_options) const
  {
    const std::string merge = scan + " " + merge_options;
    save(merge + " --delta 2");
    for (const std::string &options : cut_options) {
      const std::string cut = " " + options;
      EXPECT_TRUE(results("scan.volsurf" + cut) == results(merge + cut)) << options;
    }
  }

  /// The saved hierarchy of the ball, made with --sigma 0.5.
  std::string saved_ball() const
  {
    save(ball() + " --delta 2 --sigma 0.5");
    return read_file(work / "scan.volsurf");
  }
};

TEST_F(SavedHierarchy, GivesTheSameResultsAsTheScanAtEveryDelta)
{
  expect_cuts_as(head(48), "--oversample 1",
                 {"", "--regions 5", "--delta 20%", "--delta 5", "--delta 15 --surface hull --keep 1",
                  "--delta 15 --seed 35,0,30 --smooth 1", "--delta 10 --keep 50% --rank-by area --frame ras"});
}

TEST_F(SavedHierarchy, GivesTheSameResultsWithEveryOptionOfTheMerge)
{
  expect_cuts_as(head(32), "--sigma 0 --exterior infinite", {"--delta 15", "--delta 20 --keep 1 --snap off"});
  expect_cuts_as(head(32), "--sigma 1.5 --exterior infinite", {"--delta 2"});
  expect_cuts_as(head(32), "--edge-map", {"--delta 10"});
  expect_cuts_as(head(32), "--median 2", {"--delta 10"});
}

TEST_F(SavedHierarchy, IsKnownByItsBytesWhateverItsName)
{
  saved_ball();
  std::filesystem::rename(work / "scan.volsurf", work / "renamed.nrrd");
  EXPECT_EQ(results("renamed.nrrd --delta 2"), results(ball() + " --sigma 0.5 --delta 2"));
}

TEST_F(SavedHierarchy, IsTheSameWhenItIsSavedAgain)
{
  const std::string saved = saved_ball();
  EXPECT_EQ(run("scan.volsurf --delta 3 --save-hierarchy again.volsurf").exit_code, 0);
  EXPECT_EQ(read_file(work / "again.volsurf"), saved);
}

TEST_F(SavedHierarchy, TakesTheOptionsItWasMadeWithAndNoOthers)
{
  saved_ball();
  const std::string holds = "scan.volsurf: found the hierarchy of ball.nrrd, made with --sigma 0.5 --exterior none";
  for (const std::string option :
       {"--sigma 1", "--median 1", "--exterior infinite", "--edge-map", "--paper", "--series 1.2"})
    expect_refused("scan.volsurf --delta 2 " + option, 2, {holds});
  for (const std::string option : {"--sigma 0.5", "--median 0", "--exterior none", "--sigma 0.5 --exterior none"})
    EXPECT_EQ(run("scan.volsurf --delta 2 " + option).exit_code, 0) << option;
}

TEST_F(SavedHierarchy, OfMediansTakesNoOthers)
{
  save(ball() + " --delta 2 --sigma 1 --median 1");
  for (const std::string option : {"--median 0", "--median 2"})
    expect_refused("scan.volsurf --delta 2 " + option, 2, {"made with --median 1 --sigma 1 --exterior none"});
  EXPECT_EQ(run("scan.volsurf --delta 2 --median 1").exit_code, 0);
}

TEST_F(SavedHierarchy, OfAFinerGridCutsAsTheScanDoes)
{
  expect_cuts_as(head(32), "--oversample 2", {"--delta 10"});
}

TEST_F(SavedHierarchy, OfAFinerGridTakesNoOther)
{
  save(ball() + " --delta 2 --oversample 2");
  expect_refused("scan.volsurf --delta 2 --oversample 1", 2, {"made with --oversample 2 --sigma 0.65 --exterior none"});
  EXPECT_EQ(run("scan.volsurf --delta 2 --oversample 2").exit_code, 0);
}

TEST_F(SavedHierarchy, OfAnEdgeMapTakesNoSigma)
{
  save(head(32) + " --delta 10 --edge-map");
  const std::string holds = "made with --edge-map --exterior none";
  expect_refused("scan.volsurf --delta 2 --sigma 0", 2, {holds});
  expect_refused("scan.volsurf --delta 2 --sigma 1", 2, {holds});
  EXPECT_EQ(run("scan.volsurf --delta 10 --edge-map").exit_code, 0);
}

TEST_F(SavedHierarchy, NamesTheScanAndItselfInTheReport)
{
  saved_ball();
  const json of_scan = report_of(run(ball() + " --delta 2 --sigma 0.5 --report -"))["source"];
  const json source = report_of(run("scan.volsurf --delta 2 --report -"))["source"];
  EXPECT_EQ(source["path"], "ball.nrrd");
  EXPECT_EQ(source["hierarchy"], "scan.volsurf");
  EXPECT_EQ(of_scan["hierarchy"], nullptr);
  for (const std::string key : {"bytes", "sha256", "pixel_type"})
    EXPECT_EQ(source[key], of_scan[key]);
}

TEST_F(SavedHierarchy, IsWrittenWithAllOutputsOrNotAtAll)
{
  const std::string save = " --save-hierarchy scan.volsurf";
  expect_refused(ball() + " --delta 2 -o gone/out.vtp" + save, 5, {"gone/out.vtp"});
  expect_refused(ball() + " --delta 1e6" + save, 4, {"no boundary survives"});
  expect_refused(ball() + " --delta 2 -o out.vtp --save-hierarchy gone/scan.volsurf", 5, {"gone/scan.volsurf"});
}

TEST_F(SavedHierarchy, HasItsOwnExtensionAndName)
{
  expect_refused(ball() + " --delta 2 --save-hierarchy scan.nrrd", 2,
                 {"scan.nrrd: found the extension .nrrd; allowed: .volsurf"});
  const std::string saved = saved_ball();
  expect_refused("scan.volsurf --delta 2 --save-hierarchy ./scan.volsurf", 2, {"scan.volsurf: it is named twice"});
  EXPECT_EQ(read_file(work / "scan.volsurf"), saved);
}

TEST_F(SavedHierarchy, ThatIsDamagedCutShortOrOfANewerVersionIsRefused)
{
  const std::string saved = saved_ball();
  std::string damaged = saved;
  damaged[saved.size() / 2] = static_cast<char>(damaged[saved.size() / 2] ^ 1);
  expect_refused(input("damaged.volsurf", damaged) + " --delta 2", 3, {"damaged.volsurf: found bytes", "checksum"});
  expect_refused(input("short.volsurf", saved.substr(0, saved.size() / 2)) + " --delta 2", 3, {"checksum"});
  expect_refused(input("empty.volsurf", "") + " --delta 2", 3, {"empty.volsurf: found"});
  const std::string version = "hierarchy 1";
  const std::string newer = std::string(saved).replace(saved.find(version), version.size(), "hierarchy 2");
  expect_refused(input("newer.volsurf", newer) + " --delta 2", 3,
                 {"newer.volsurf: found \"volsurf hierarchy 2\"", "allowed: \"volsurf hierarchy 1\""});
  expect_refused(input("foreign.volsurf", "GIF89a") + " --delta 2", 3, {"foreign.volsurf: found"});
}

TEST_F(SavedHierarchy, ThatNeedsMoreMemoryThanAllowedIsRefused)
{
  saved_ball();
  expect_refused("scan.volsurf --delta 2 --max-memory 1M", 3, {"18 x 18 x 18 samples", "--max-memory"});
}

TEST_F(SavedHierarchy, IsReadByThePythonOfItsDocumentation)
{
  constexpr char kPython[] = "/usr/bin/python3";
  if (run_program(work.path(), std::string(kPython) + " -c 'import numpy'").exit_code != 0)
    GTEST_SKIP() << "python3-numpy is missing";
  save(head(32) + " --delta 10 --labels labels.nrrd");
  write_file(inputs / "check.py", R"(import gzip, re, sys
document, hierarchy, labels = sys.argv[1:]
for code in re.findall(r"```python\n(.*?)```", open(document).read(), re.DOTALL):
    exec(code)
facts, arrays = read_hierarchy(hierarchy)
regions = regions(arrays, 10)
labels = gzip.decompress(open(labels, "rb").read().split(b"\n\n", 1)[1])
labels = numpy.frombuffer(labels, numpy.dtype(f"<u{len(labels) // len(regions)}"))
pairs = numpy.unique(numpy.stack([regions, labels]), axis=1)
assert pairs.shape[1] == len(numpy.unique(regions)) == len(numpy.unique(labels)) > 1
assert arrays["samples"].size == numpy.prod(facts["grid"]["size"]) == 32 ** 3
assert facts["source"]["name"] == "head.nrrd"
)");
  const Outcome outcome =
      run_program(work.path(), std::string(kPython) + " " + (inputs / "check.py").string() +
                                   " " VOLSURF_SOURCE "/docs/hierarchy_format.md scan.volsurf labels.nrrd");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

} // namespace
} // namespace volsurf::test
