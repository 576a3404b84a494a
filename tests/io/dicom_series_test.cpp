#include "io/volume_files.h"
#include "support/temporary_folder.h"
#include "volsurf/io/itk_image_io.h"
#include "volsurf/io/read_volume.h"

#include <itkGDCMImageIO.h>
#include <itkMetaDataObject.h>

namespace fs = std::filesystem;

namespace volsurf {
namespace {

using namespace test;

const std::string kUid = "1.2.826.0.1.3680043.2.1125.1.";

struct Slice {
  std::string series = kUid + "1";
  std::string description = "T1 head";
  int number = 0;
  Vec3 position_mm{0, 0, 0};
  int columns = 4;
  int components = 1;
};

/// A slice whose samples are 100 * number + index; column spacing 0.5, row spacing 2.
void write_slice(const fs::path &file, const Slice &slice)
{
  const QuietItk quiet;
  const auto io = itk::GDCMImageIO::New();
  itk::MetaDataDictionary &tags = io->GetMetaDataDictionary();
  const auto set = [&tags](const char *tag, const std::string &value) {
    itk::EncapsulateMetaData<std::string>(tags, tag, value);
  };
  set("0008|0060", "MR");
  set("0008|0016", "1.2.840.10008.5.1.4.1.1.4");
  set("0008|0018", slice.series + ".5." + std::to_string(slice.number + 1));
  set("0020|000d", kUid + "9");
  set("0020|000e", slice.series);
  set("0020|0013", std::to_string(slice.number + 1));
  set("0020|0052", kUid + "8");
  set("0008|103e", slice.description);
  io->KeepOriginalUIDOn();
  io->SetFileName(file.string());
  io->SetNumberOfDimensions(3);
  io->SetNumberOfComponents(static_cast<unsigned int>(slice.components));
  io->SetPixelType(slice.components == 1 ? itk::IOPixelEnum::SCALAR : itk::IOPixelEnum::RGB);
  io->SetComponentType(slice.components == 1 ? itk::IOComponentEnum::SHORT : itk::IOComponentEnum::UCHAR);
  const std::array<unsigned int, 3> size{static_cast<unsigned int>(slice.columns), 3, 1};
  const Vec3 spacing_mm{0.5, 2, 3};
  itk::ImageIORegion region(3);
  for (unsigned int axis = 0; axis < 3; ++axis) {
    io->SetDimensions(axis, size[axis]);
    io->SetSpacing(axis, spacing_mm[axis]);
    io->SetOrigin(axis, slice.position_mm[axis]);
    std::vector<double> direction(3, 0);
    direction[axis] = 1;
    io->SetDirection(axis, direction);
    region.SetSize(axis, size[axis]);
  }
  io->SetIORegion(region);
  std::vector<std::int16_t> samples(static_cast<std::size_t>(slice.columns * 3 * slice.components));
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = static_cast<std::int16_t>(100 * slice.number + static_cast<int>(i));
  io->Write(samples.data());
}

/// Slices 3 mm apart from z = 10, written in the reverse order of their names.
void write_series(const fs::path &folder, Slice slice, int count)
{
  for (int i = 0; i < count; ++i) {
    slice.number = i;
    slice.position_mm = {1, -2, 10 + 3.0 * i};
    write_slice(folder / (slice.description.substr(0, 2) + std::to_string(99 - i) + ".dcm"), slice);
  }
}

TEST(ReadDicom, StacksTheSlicesOfAFolderByPosition)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {}, 5);
  write_file(folder / "README.txt", "not DICOM");
  const InputVolume input = read_volume(folder.path());
  const Grid &grid = input.volume.grid;
  EXPECT_EQ(grid.size, (Index3{4, 3, 5}));
  const Vec3 first = index_to_world(grid, {0, 0, 0});
  const Vec3 last = index_to_world(grid, {3, 2, 4});
  const Vec3 expected_first{1, -2, 10};
  const Vec3 expected_last{2.5, 2, 22};
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(first[axis], expected_first[axis], 1e-6);
    EXPECT_NEAR(last[axis], expected_last[axis], 1e-6);
  }
  for (std::size_t i = 0; i < 60; ++i)
    EXPECT_EQ(input.volume.samples[i], static_cast<float>(100 * (i / 12) + i % 12));
  EXPECT_EQ(input.pixel_type, "int16");
  EXPECT_EQ(input.source.path, folder.path().string());
}

TEST(ReadDicom, CountsTheBytesOfItsSeriesOnly)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {}, 3);
  std::uintmax_t bytes = 0;
  for (const auto &entry : fs::directory_iterator(folder.path()))
    bytes += entry.file_size();
  write_file(folder / "other", "not DICOM");
  EXPECT_EQ(read_volume(folder.path()).source.bytes, bytes);
}

TEST(ReadDicom, ListsSeveralSeriesAndTakesTheOneNamed)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {}, 5);
  write_series(folder.path(), {kUid + "2", "FLAIR", 0, {}, 4, 1}, 3);
  const std::string message = refusal(folder.path());
  EXPECT_TRUE(contains(message, "found 2 DICOM series; allowed: one; choose by --series UID: "));
  EXPECT_TRUE(contains(message, kUid + "1"));
  EXPECT_TRUE(contains(message, "(\"T1 head\", 5 files)"));
  EXPECT_TRUE(contains(message, kUid + "2"));
  EXPECT_TRUE(contains(message, "(\"FLAIR\", 3 files)"));
  ReadOptions options;
  options.series_uid = kUid + "2";
  EXPECT_EQ(read_volume(folder.path(), options).volume.grid.size, (Index3{4, 3, 3}));
  options.series_uid = kUid + "7";
  EXPECT_TRUE(contains(refusal(folder.path(), options), "found no series " + kUid + "7"));
}

TEST(ReadDicom, RefusesAFolderWithoutDicom)
{
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(refusal(folder.path()), "found a folder without DICOM images"));
  write_file(folder / "README.txt", "not DICOM");
  EXPECT_TRUE(contains(refusal(folder.path()), "found a folder without DICOM images"));
}

TEST(ReadDicom, RefusesAMissingSlice)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {}, 6);
  fs::remove(folder / "T197.dcm");
  EXPECT_TRUE(contains(refusal(folder.path()), "allowed: evenly spaced slices, none missing"));
}

TEST(ReadDicom, RefusesSlicesOfDifferentSizes)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {}, 3);
  write_slice(folder / "T1odd.dcm", {kUid + "1", "T1 head", 3, {1, -2, 19}, 5, 1});
  EXPECT_TRUE(contains(refusal(folder.path()), "another size"));
}

TEST(ReadDicom, RefusesASingleSlice)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {}, 1);
  EXPECT_TRUE(contains(refusal(folder.path()), "4 x 3 x 1 samples; allowed: 2 or more on each axis"));
}

TEST(ReadDicom, RefusesTwoSlicesAtOnePosition)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {}, 3);
  write_slice(folder / "T1again.dcm", {kUid + "1", "T1 head", 1, {1, -2, 13}, 4, 1});
  EXPECT_TRUE(contains(refusal(folder.path()), "found two slices at one position"));
}

TEST(ReadDicom, RefusesColours)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {kUid + "1", "RGB", 0, {}, 4, 3}, 3);
  EXPECT_TRUE(contains(refusal(folder.path()), "allowed: one scalar per sample"));
}

TEST(ReadDicom, RefusesEveryTruncationOfASlice)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {}, 5);
  const fs::path file = folder / "T197.dcm";
  const std::string whole = read_file(file);
  for (std::size_t size = 0; size < whole.size(); size += size + 40 < whole.size() ? 13 : 1) {
    write_file(file, whole.substr(0, size));
    ASSERT_NE(refusal(folder.path()), "") << "cut to " << size << " of " << whole.size();
  }
}

TEST(ReadDicom, RefusesMetaInformationOnWhichGdcmAborts)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {}, 3);
  const fs::path file = folder / "T198.dcm";
  const std::string whole = read_file(file);
  for (const std::size_t at : {132U, 136U, 138U, 140U, 144U, 148U}) { // tag, type, length, value, next tag and type
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
    write_file(file, damaged);
    EXPECT_TRUE(contains(refusal(folder.path()), "damaged or ends too soon")) << "byte " << at;
  }
}

} // namespace
} // namespace volsurf
