#include "volsurf/io/write_volume.h"

#include "io/full_disk.h"
#include "io/meshes.h"
#include "support/temporary_folder.h"
#include "volsurf/io/read_volume.h"

#include <random>

namespace fs = std::filesystem;

namespace volsurf {
namespace {

using namespace test;

Grid oblique_grid()
{
  Grid grid;
  grid.size = {3, 4, 5};
  grid.spacing_mm = {0.7, 1.1, 2};
  grid.origin_mm = {-12.25, 7, 1000};
  grid.direction = {Vec3{0.8, -0.6, 0}, Vec3{0.6, 0.8, 0}, Vec3{0, 0, -1}};
  return grid;
}

LabelVolume labels_up_to(std::uint32_t highest)
{
  LabelVolume labels{oblique_grid(), {}};
  labels.labels.assign(60, 1);
  labels.labels[17] = highest;
  return labels;
}

void expect_same_place(const Grid &found, const Grid &expected)
{
  EXPECT_EQ(found.size, expected.size);
  for (const Vec3 &index : {Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{0, 3, 0}, Vec3{0, 0, 4}}) {
    const Vec3 a = index_to_world(found, index);
    const Vec3 b = index_to_world(expected, index);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(a[axis], b[axis], 1e-9);
  }
}

TEST(WriteLabels, UsesTheSmallestTypeThatHoldsThem)
{
  const TemporaryFolder folder;
  for (const auto &[highest, type] : std::vector<std::pair<std::uint32_t, std::string>>{
           {0, "uint8"}, {255, "uint8"}, {256, "uint16"}, {65535, "uint16"}, {65536, "uint32"}}) {
    write_labels(labels_up_to(highest), folder / "a.nrrd", provenance());
    const InputVolume input = read_volume(folder / "a.nrrd");
    EXPECT_EQ(input.pixel_type, type);
    EXPECT_EQ(input.volume.samples[17], static_cast<float>(highest));
    EXPECT_EQ(input.volume.samples[18], 1);
  }
}

TEST(WriteLabels, KeepsThePlaceInTheWorld)
{
  const TemporaryFolder folder;
  write_labels(labels_up_to(3), folder / "a.nrrd", provenance());
  expect_same_place(read_volume(folder / "a.nrrd").volume.grid, oblique_grid());
}

TEST(WriteLabels, SaysItsMakingInKeyValuePairs)
{
  const TemporaryFolder folder;
  write_labels(labels_up_to(3), folder / "a.nrrd", provenance());
  const std::string file = read_file(folder / "a.nrrd");
  for (const char *line : {"\nencoding: gzip\n", "\nspace: left-posterior-superior\n", "\nVersion:=volsurf 1.2.3\n",
                           "\nSource:=head.nrrd\n", "\nOptions:=--delta 20 --keep 5%\n"})
    EXPECT_NE(file.find(line), std::string::npos) << line;
}

TEST(WriteVolume, RoundsAndClampsToThePixelType)
{
  const TemporaryFolder folder;
  Volume volume{oblique_grid(), std::vector<float>(60, 0.25F)};
  volume.samples[0] = -1e6F;
  volume.samples[1] = 1e6F;
  volume.samples[2] = 12.6F;
  const auto samples_as = [&](PixelType type, const std::string &name) {
    write_volume(volume, type, folder / "a.nrrd", provenance());
    const InputVolume input = read_volume(folder / "a.nrrd");
    EXPECT_EQ(input.pixel_type, name);
    expect_same_place(input.volume.grid, oblique_grid());
    return std::vector<float>(input.volume.samples.begin(), input.volume.samples.begin() + 4);
  };
  EXPECT_EQ(samples_as(PixelType::uint8, "uint8"), (std::vector<float>{0, 255, 13, 0}));
  EXPECT_EQ(samples_as(PixelType::int16, "int16"), (std::vector<float>{-32768, 32767, 13, 0}));
  EXPECT_EQ(samples_as(PixelType::uint16, "uint16"), (std::vector<float>{0, 65535, 13, 0}));
  EXPECT_EQ(samples_as(PixelType::float32, "float32"), (std::vector<float>{-1e6F, 1e6F, 12.6F, 0.25F}));
}

TEST(WriteVolume, IsTheSameBytesForTheSameInput)
{
  const TemporaryFolder folder;
  for (const char *name : {"a.nrrd", "b.nrrd"})
    write_labels(labels_up_to(3), folder / name, provenance());
  EXPECT_EQ(read_file(folder / "a.nrrd"), read_file(folder / "b.nrrd"));
}

TEST(WriteVolume, NoticesAFullDisk)
{
  std::mt19937 random(1);
  Volume volume;
  volume.grid.size = {40, 40, 40};
  for (int i = 0; i < 64000; ++i)
    volume.samples.push_back(static_cast<float>(random() % 256));
  expect_full_disk_is_noticed(
      "a.nrrd", [&](const fs::path &file) { write_volume(volume, PixelType::uint8, file, provenance()); });
}

TEST(WriteVolume, AMissingFolderIsAnOutputErrorAndPrintsNothing)
{
  const TemporaryFolder folder;
  testing::internal::CaptureStderr();
  try {
    write_labels(labels_up_to(3), folder / "missing/a.nrrd", provenance());
    ADD_FAILURE();
  } catch (const OutputError &error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(WriteVolume, TakesNrrdOnly)
{
  EXPECT_NO_THROW(require_nrrd_extension("a.nrrd"));
  EXPECT_THROW(require_nrrd_extension("a.nhdr"), UsageError);
  EXPECT_THROW(require_nrrd_extension("a"), UsageError);
}

} // namespace
} // namespace volsurf
