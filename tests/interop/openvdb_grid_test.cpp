#include "volsurf/interop/openvdb_grid.h"

#include "io/full_disk.h"
#include "io/meshes.h"
#include "support/temporary_folder.h"

#include <array>
#include <cstdio>
#include <random>

namespace fs = std::filesystem;

namespace volsurf {
namespace {

using namespace test;

Volume magnitude(const Index3 &size)
{
  std::mt19937 random(1);
  Volume volume;
  volume.grid.size = size;
  volume.grid.spacing_mm = {0.5, 1, 2};
  volume.grid.origin_mm = {-10, 20, 30};
  for (std::int64_t i = 0; i < volume.grid.sample_count(); ++i)
    volume.samples.push_back(1.0F + static_cast<float>(random() % 1000));
  return volume;
}

LabelVolume regions(const Grid &samples)
{
  LabelVolume labels{cell_centre_grid(samples), {}};
  for (std::int64_t i = 0; i < labels.grid.sample_count(); ++i)
    labels.labels.push_back(static_cast<std::uint32_t>(i % 3));
  return labels;
}

void write(const fs::path &file, const Volume &volume, Frame frame = Frame::lps)
{
  write_vdb(regions(volume.grid), volume, file, provenance(), frame);
}

/// What a program prints, or nothing where it is not installed.
std::string output_of(const std::string &command)
{
  std::FILE *pipe = popen((command + " 2>/dev/null").c_str(), "r");
  std::string text;
  std::array<char, 4096> block{};
  while (pipe != nullptr && std::fgets(block.data(), block.size(), pipe) != nullptr)
    text += block.data();
  return pipe != nullptr && pclose(pipe) == 0 ? text : "";
}

void expect_parts(const std::string &text, const std::vector<std::string> &parts)
{
  for (const std::string &part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is missing in\n" << text;
}

TEST(WriteVdb, IsReadByVdbPrint)
{
  const TemporaryFolder folder;
  write(folder / "a.vdb", magnitude({9, 8, 7}));
  const std::string text = output_of("vdb_print -l " + (folder / "a.vdb").string());
  if (text.empty())
    GTEST_SKIP() << "vdb_print is not installed (package libopenvdb-tools)";
  expect_parts(text, {"Name: regions", "Name: gradient_magnitude", "Tree_int32", "Tree_float", "class: fog volume",
                      "[0.5, 0, 0, 0]", "[0, 1, 0, 0]", "[0, 0, 2, 0]", "[-10, 20, 30, 1]", "[-9.75, 20.5, 31, 1]",
                      "SPACE: LPS", "Version: volsurf 1.2.3", "Source: head.nrrd", "Options: --delta 20 --keep 5%",
                      "Number of active voxels:       504", "Number of active voxels:       224"});
}

TEST(WriteVdb, KeepsAnObliqueTransform)
{
  const TemporaryFolder folder;
  Volume volume = magnitude({9, 8, 7});
  volume.grid.direction = {Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, -1}};
  write(folder / "a.vdb", volume, Frame::ras);
  const std::string text = output_of("vdb_print -l " + (folder / "a.vdb").string());
  if (text.empty())
    GTEST_SKIP() << "vdb_print is not installed (package libopenvdb-tools)";
  expect_parts(text, {"[0, -0.5, 0, 0]", "[1, 0, 0, 0]", "[0, 0, -2, 0]", "[10, -20, 30, 1]", "SPACE: RAS"});
}

TEST(WriteVdb, IsTheSameBytesForTheSameInput)
{
  const TemporaryFolder folder;
  write(folder / "a.vdb", magnitude({19, 18, 17}));
  write(folder / "b.vdb", magnitude({19, 18, 17}));
  EXPECT_EQ(read_file(folder / "a.vdb"), read_file(folder / "b.vdb"));
}

TEST(WriteVdb, NoticesAFullDisk)
{
  const Volume volume = magnitude({40, 40, 40});
  expect_full_disk_is_noticed("a.vdb", [&](const fs::path &file) { write(file, volume); });
}

TEST(WriteVdb, AMissingFolderIsAnOutputError)
{
  const TemporaryFolder folder;
  EXPECT_THROW(write(folder / "missing/a.vdb", magnitude({4, 4, 4})), OutputError);
}

} // namespace
} // namespace volsurf
