// Inputs that cannot be used: exit code 3 and one line, or 4 where there is nothing to find.
#include "cli/volsurf_program.h"

#include <chrono>
#include <limits>

namespace volsurf::test {
namespace {

class BadInput : public VolsurfProgram {
protected:
  void expect_input_refused(const std::string &path, const std::string &found) const
  {
    expect_refused("'" + path + "' --delta 2", 3, {path, found});
  }
};

TEST_F(BadInput, MissingFileIsNamed)
{
  expect_input_refused("gone.nrrd", "does not exist");
}

TEST_F(BadInput, FolderWithoutDicomIsSaidToBeOne)
{
  input("notes.txt", "no images");
  expect_input_refused(inputs.path().string(), "a folder without DICOM images; allowed: a folder with a DICOM series");
}

TEST_F(BadInput, TruncatedRawNrrdTellsBytesFoundAndAnnounced)
{
  const std::string whole = float_nrrd(ball_samples());
  expect_input_refused(input("cut.nrrd", whole.substr(0, whole.size() - 1)),
                       "found 23327 bytes of samples where the header announces 23328");
}

TEST_F(BadInput, TruncatedGzipNrrdIsRefused)
{
  const std::string packed = gzip(bytes_of(ball_samples()));
  const std::string header = nrrd_header("float", kBallSizes, "encoding: gzip\n") + "\n";
  EXPECT_EQ(run(input("whole.nrrd", header + packed) + " --delta 2 -o whole.vtp").exit_code, 0);
  expect_input_refused(input("cut.nrrd", header + packed.substr(0, packed.size() / 2)), "compressed");
}

TEST_F(BadInput, WrongMagicTellsTheFormatsThatAreRead)
{
  expect_input_refused(input("a.nrrd", "JPEG, really"), "does not begin like NRRD; allowed: NRRD (.nrrd, .nhdr), Meta");
}

TEST_F(BadInput, EmptyFilesAreRefusedInEveryFormat)
{
  for (const std::string name : {"a.nrrd", "a.nhdr", "a.mha", "a.mhd", "a.nii", "a.nii.gz"})
    expect_input_refused(input(name, ""), "does not begin like");
}

TEST_F(BadInput, NameWithoutExtensionTellsTheFormatsThatAreRead)
{
  expect_input_refused(input("scan", float_nrrd(ball_samples())), "a file of unknown kind; allowed: NRRD");
}

TEST_F(BadInput, DamagedNiftiHeaderIsRefused)
{
  NiftiHeader header;
  header.sizes = {-3, 4, 5};
  expect_input_refused(input("a.nii", header.bytes()), "found impossible sizes in the NIfTI header");
}

TEST_F(BadInput, DetachedHeaderWithoutItsDataNamesTheMissingFile)
{
  const std::string header = nrrd_header("float", kBallSizes, "encoding: raw\ndata file: gone.raw\n");
  expect_input_refused(input("a.nhdr", header), "data file gone.raw does not exist");
}

TEST_F(BadInput, RgbVolumeIsRefused)
{
  expect_input_refused(input("rgb.nrrd", nrrd_header("uchar", "3 4 4 4",
                                                     "encoding: raw\nkinds: RGB-color domain "
                                                     "domain domain\n") +
                                             "\n" + std::string(192, 'x')),
                       "found pixels of kind rgb with 3 components; allowed: one scalar per sample");
}

TEST_F(BadInput, FlatImageIsRefused)
{
  expect_input_refused(input("flat.nrrd", float_nrrd(std::vector<float>(16), "4 4")),
                       "found a 2-D image (4 x 4); allowed: a 3-D volume");
}

TEST_F(BadInput, VolumeOneSampleThinIsRefused)
{
  expect_input_refused(input("thin.nrrd", float_nrrd(std::vector<float>(16), "4 4 1")), "4 x 4 x 1");
}

TEST_F(BadInput, NotFiniteSamplesAreCountedAndTheFirstIsNamed)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  expect_input_refused(input("nan.nrrd", float_nrrd(std::vector<float>(64, nan), "4 4 4")),
                       "found 64 samples that are not finite, the first at index (0, 0, 0); allowed: finite samples");
}

TEST_F(BadInput, OneNotFiniteSampleIsEnough)
{
  std::vector<float> samples = ball_samples();
  samples[1 + kBallSize * (2 + kBallSize * 3)] = std::numeric_limits<float>::quiet_NaN();
  expect_input_refused(input("nan.nrrd", float_nrrd(samples)), "found 1 sample that is not finite, the first at "
                                                               "index (1, 2, 3)");
}

TEST_F(BadInput, HugeClaimsAreRefusedBeforeAnyMemoryIsTaken)
{
  const auto start = std::chrono::steady_clock::now();
  const auto claim = [this](const std::string &sizes) {
    return input("huge.nrrd", nrrd_header("short", sizes, "encoding: raw\n") + "\nabc");
  };
  expect_input_refused(claim("1000000 1000000 1000000"), "1000000 x 1000000 x 1000000");
  const std::string path = claim("1000 1000 1000"); // more than a small machine has: that is not what is tested here
  expect_refused(path + " --delta 2 --max-memory 100G", 3,
                 {path, "3 bytes of samples where the header announces 2000000000"});
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST_F(BadInput, MoreMemoryThanAllowedIsRefusedWithTheFigure)
{
  const std::string path = ball();
  expect_refused(path + " --delta 2 --max-memory 1M", 3, {path, "which need 0.08", "GB (--max-memory)"});
  EXPECT_EQ(run(path + " --delta 2 --max-memory 1G -o ball.vtp").exit_code, 0);
}

TEST_F(BadInput, DevicesAreRefused)
{
  expect_input_refused("/dev/zero", "found a device or pipe");
}

TEST_F(BadInput, ConstantVolumeHasNothingToWrite)
{
  const std::string path = input("flat.nrrd", float_nrrd(std::vector<float>(64, 7), "4 4 4"));
  expect_refused(path + " --delta 2", 4, {path, "no boundary survives delta = 2", "the largest persistence is 0"});
}

TEST_F(BadInput, DeltaAboveEverythingTellsTheLargestPersistence)
{
  const Outcome verbose = run(ball() + " --delta 2 -v -o ball.vtp");
  const auto at = verbose.err.find("largest persistence ");
  ASSERT_NE(at, std::string::npos) << verbose.err;
  const std::string largest = first_line(verbose.err.substr(at + std::string("largest persistence ").size()));
  expect_refused(ball() + " --delta 1e6", 4,
                 {"no boundary survives delta = 1e+06; the largest persistence is " + largest + "\n"});
}

TEST_F(BadInput, LineBreakInANameLeavesTheMessageOneLine)
{
  expect_refused("'two\nlines.nrrd' --delta 2", 3, {"two lines.nrrd: the file does not exist"});
}

TEST_F(BadInput, NamesThatCannotBeFollowedAreMissingFiles)
{
  std::filesystem::create_symlink("loop.nrrd", work / "loop.nrrd");
  expect_refused("loop.nrrd --delta 2", 3, {"loop.nrrd: the file does not exist"});
  expect_refused(std::string(300, 'n') + ".nrrd --delta 2", 3, {"n.nrrd: the file does not exist"});
}

} // namespace
} // namespace volsurf::test
