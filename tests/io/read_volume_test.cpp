#include "volsurf/io/read_volume.h"

#include "io/volume_files.h"
#include "support/temporary_folder.h"
#include "volsurf/io/sha256.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace fs = std::filesystem;

namespace volsurf {
namespace {

using namespace test;

constexpr int kSamples = 60; // of 3 x 4 x 5

void expect_ramp(const InputVolume &input)
{
  EXPECT_EQ(input.volume.grid.size, (Index3{3, 4, 5}));
  std::vector<float> expected(kSamples);
  std::iota(expected.begin(), expected.end(), 0.0F);
  EXPECT_EQ(std::vector<float>(input.volume.samples.begin(), input.volume.samples.end()), expected);
}

void expect_near(const Vec3 &found, const Vec3 &expected)
{
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(found[axis], expected[axis], 1e-5) << "axis " << axis;
}

/// World position of the last sample, which depends on all of the geometry.
Vec3 last_corner(const InputVolume &input)
{
  return index_to_world(input.volume.grid, {2, 3, 4});
}

template <typename Value>
void expect_pixel_type(const std::string &nrrd_type, const std::string &meta_type, int nifti_type,
                       const std::string &name)
{
  SCOPED_TRACE(name);
  const TemporaryFolder folder;
  const std::string data = ramp<Value>(kSamples);
  write_file(folder / "a.nrrd", nrrd_header(nrrd_type, "3 4 5", "encoding: raw\n\n") + data);
  write_file(folder / "a.mha", meta_header(meta_type, "3 4 5", "") + data);
  NiftiHeader header;
  header.datatype = static_cast<std::int16_t>(nifti_type);
  header.bits = 8 * sizeof(Value);
  write_file(folder / "a.nii", header.bytes() + data);
  for (const char *file : {"a.nrrd", "a.mha", "a.nii"}) {
    SCOPED_TRACE(file);
    const InputVolume input = read_volume(folder / file);
    expect_ramp(input);
    EXPECT_EQ(input.pixel_type, name);
  }
}

TEST(ReadVolume, TakesEveryScalarPixelType)
{
  expect_pixel_type<std::uint8_t>("uint8", "MET_UCHAR", 2, "uint8");
  expect_pixel_type<std::int8_t>("int8", "MET_CHAR", 256, "int8");
  expect_pixel_type<std::uint16_t>("uint16", "MET_USHORT", 512, "uint16");
  expect_pixel_type<std::int16_t>("int16", "MET_SHORT", 4, "int16");
  expect_pixel_type<std::uint32_t>("uint32", "MET_UINT", 768, "uint32");
  expect_pixel_type<std::int32_t>("int32", "MET_INT", 8, "int32");
  expect_pixel_type<std::uint64_t>("uint64", "MET_ULONG_LONG", 1280, "uint64");
  expect_pixel_type<std::int64_t>("int64", "MET_LONG_LONG", 1024, "int64");
  expect_pixel_type<float>("float", "MET_FLOAT", 16, "float32");
  expect_pixel_type<double>("double", "MET_DOUBLE", 64, "float64");
}

TEST(ReadVolume, SwapsBigEndianSamples)
{
  const TemporaryFolder folder;
  std::string data = ramp<std::int16_t>(kSamples);
  for (std::size_t i = 0; i < data.size(); i += 2)
    std::swap(data[i], data[i + 1]);
  write_file(folder / "a.nrrd",
             "NRRD0004\ntype: short\ndimension: 3\nsizes: 3 4 5\nendian: big\nencoding: raw\n\n" + data);
  expect_ramp(read_volume(folder / "a.nrrd"));
}

TEST(ReadVolume, ReadsNrrdInAllItsArrangements)
{
  const TemporaryFolder folder;
  const std::string data = ramp<std::int16_t>(kSamples);
  const std::string skipped(256, 'h');
  const auto header = [](const std::string &more) { return nrrd_header("short", "3 4 5", more); };
  write_file(folder / "gzip.nrrd", header("encoding: gzip\n\n") + gzip(data));
  write_file(
      folder / "ascii.nrrd", header("encoding: ascii\n\n") + [] {
        std::string text;
        for (int i = 0; i < kSamples; ++i)
          text += std::to_string(i) + "\n";
        return text;
      }());
  write_file(folder / "data.raw", data);
  write_file(folder / "data.raw.gz", gzip(data));
  write_file(folder / "skipped.inr", skipped + data);
  write_file(folder / "skipped.inr.gz", gzip(skipped + data));
  write_file(folder / "lines.raw", "first line\nsecond line\n" + data);
  write_file(folder / "part1.raw", data.substr(0, 72));
  write_file(folder / "part2.raw", data.substr(72));
  write_file(folder / "raw.nhdr", header("encoding: raw\ndata file: data.raw\n"));
  write_file(folder / "gzip.nhdr", header("encoding: gzip\ndata file: data.raw.gz\n"));
  write_file(folder / "skip.nhdr", header("encoding: raw\nbyte skip: 256\ndata file: skipped.inr\n"));
  write_file(folder / "skip_all.nhdr", header("encoding: raw\nbyte skip: -1\ndata file: skipped.inr\n"));
  write_file(folder / "skip_gzip.nhdr", header("encoding: gzip\nbyte skip: 256\ndata file: skipped.inr.gz\n"));
  write_file(folder / "lines.nhdr", header("encoding: raw\nline skip: 2\ndata file: lines.raw\n"));
  write_file(folder / "detached.nrrd", header("encoding: raw\ndata file: data.raw\n"));
  for (const char *file : {"gzip.nrrd", "ascii.nrrd", "raw.nhdr", "gzip.nhdr", "skip.nhdr", "skip_all.nhdr",
                           "skip_gzip.nhdr", "lines.nhdr", "detached.nrrd"}) {
    SCOPED_TRACE(file);
    expect_ramp(read_volume(folder / file));
  }
}

TEST(ReadVolume, ReadsMetaImageInAllItsArrangements)
{
  const TemporaryFolder folder;
  const std::string data = ramp<std::int16_t>(kSamples);
  const std::string packed = zlib(data);
  const std::string compressed = "CompressedData = True\nCompressedDataSize = " + std::to_string(packed.size()) + "\n";
  write_file(folder / "data.raw", data);
  write_file(folder / "data.zraw", packed);
  write_file(folder / "skipped.raw", std::string(100, 'h') + data);
  write_file(folder / "z.mha", meta_header("MET_SHORT", "3 4 5", compressed) + packed);
  write_file(folder / "raw.mhd", meta_header("MET_SHORT", "3 4 5", "", "data.raw"));
  write_file(folder / "z.mhd", meta_header("MET_SHORT", "3 4 5", compressed, "data.zraw"));
  write_file(folder / "skip.mhd", meta_header("MET_SHORT", "3 4 5", "HeaderSize = 100\n", "skipped.raw"));
  write_file(folder / "skip_all.mhd", meta_header("MET_SHORT", "3 4 5", "HeaderSize = -1\n", "skipped.raw"));
  std::string slices = "LIST";
  for (int z = 0; z < 5; ++z) {
    const std::string name = "slice" + std::to_string(z) + ".raw";
    write_file(folder / name, data.substr(static_cast<std::size_t>(z) * 24, 24));
    slices += "\n" + name;
  }
  write_file(folder / "list.mhd", meta_header("MET_SHORT", "3 4 5", "", slices));
  write_file(folder / "pattern.mhd", meta_header("MET_SHORT", "3 4 5", "", "slice%d.raw 0 4 1"));
  for (const char *file : {"z.mha", "raw.mhd", "z.mhd", "skip.mhd", "skip_all.mhd", "list.mhd", "pattern.mhd"}) {
    SCOPED_TRACE(file);
    expect_ramp(read_volume(folder / file));
  }
}

TEST(ReadVolume, ReadsNiftiPlainAndGzipped)
{
  const TemporaryFolder folder;
  const std::string file = NiftiHeader{}.bytes() + ramp<std::int16_t>(kSamples);
  write_file(folder / "a.nii", file);
  write_file(folder / "a.nii.gz", gzip(file));
  expect_ramp(read_volume(folder / "a.nii"));
  expect_ramp(read_volume(folder / "a.nii.gz"));
}

TEST(ReadVolume, AppliesTheNiftiScale)
{
  const TemporaryFolder folder;
  NiftiHeader header;
  header.slope = 0.5;
  header.intercept = 10;
  write_file(folder / "a.nii", header.bytes() + ramp<std::int16_t>(kSamples));
  EXPECT_EQ(read_volume(folder / "a.nii").volume.samples[59], 39.5F);
}

TEST(ReadVolume, AcceptsFurtherAxesOfOneSample)
{
  const TemporaryFolder folder;
  NiftiHeader header;
  header.sizes = {3, 4, 5, 1};
  write_file(folder / "a.nii", header.bytes() + ramp<std::int16_t>(kSamples));
  write_file(folder / "a.nrrd", nrrd_header("short", "3 4 5 1", "encoding: raw\n\n") + ramp<std::int16_t>(kSamples));
  write_file(folder / "a.mha", meta_header("MET_SHORT", "3 4 5 1", "") + ramp<std::int16_t>(kSamples));
  expect_ramp(read_volume(folder / "a.nii"));
  expect_ramp(read_volume(folder / "a.nrrd"));
  expect_ramp(read_volume(folder / "a.mha"));
}

TEST(ReadVolume, KeepsAnObliqueMirroredAffine)
{
  // Axes turned by 30 degrees about z, the third one mirrored.
  const TemporaryFolder folder;
  const double c = 0.8660254037844387;
  const double s = 0.5;
  const std::string data = ramp<std::int16_t>(kSamples);
  write_file(folder / "a.nrrd",
             nrrd_header("short", "3 4 5",
                         "space: left-posterior-superior\nencoding: raw\nspace origin: (10,-20,30)\n"
                         "space directions: (1.7320508075688774,1,0) (-1.5,2.598076211353316,0) (0,0,-4)\n\n") +
                 data);
  write_file(folder / "a.mha",
             meta_header("MET_SHORT", "3 4 5",
                         "TransformMatrix = 0.8660254037844387 0.5 0 -0.5 0.8660254037844387 0 0 0 -1\n"
                         "Offset = 10 -20 30\nElementSpacing = 2 3 4\n") +
                 data);
  NiftiHeader header; // RAS: x and y change sign
  header.sform_code = 1;
  header.pixdim = {-1, 2, 3, 4};
  header.sform = {float(-2 * c), float(3 * s), 0, -10, float(-2 * s), float(-3 * c), 0, 20, 0, 0, -4, 30};
  write_file(folder / "a.nii", header.bytes() + data);
  for (const char *file : {"a.nrrd", "a.mha", "a.nii"}) {
    SCOPED_TRACE(file);
    const InputVolume input = read_volume(folder / file);
    const Grid &grid = input.volume.grid;
    expect_near(grid.spacing_mm, {2, 3, 4});
    expect_near(grid.origin_mm, {10, -20, 30});
    expect_near(grid.direction[0], {c, -s, 0});
    expect_near(grid.direction[1], {s, c, 0});
    expect_near(grid.direction[2], {0, 0, -1});
    EXPECT_TRUE(is_mirrored(grid));
    expect_near(last_corner(input), {10 + 4 * c - 9 * s, -20 + 4 * s + 9 * c, 30 - 16});
    EXPECT_TRUE(input.warnings.empty());
  }
}

TEST(ReadVolume, TurnsNrrdSpacesIntoLps)
{
  const TemporaryFolder folder;
  write_file(folder / "a.nrrd", nrrd_header("short", "3 4 5",
                                            "space: right-anterior-superior\nencoding: raw\nspace origin: (10,20,30)\n"
                                            "space directions: (1,0,0) (0,2,0) (0,0,3)\n\n") +
                                    ramp<std::int16_t>(kSamples));
  const InputVolume input = read_volume(folder / "a.nrrd");
  expect_near(input.volume.grid.origin_mm, {-10, -20, 30});
  expect_near(last_corner(input), {-12, -26, 42});
}

TEST(ReadVolume, UsesTheNiftiQform)
{
  const TemporaryFolder folder;
  NiftiHeader header;
  header.pixdim = {1, 2, 3, 4};
  header.qform_code = 1;
  header.quaternion_and_offset = {0, 0, 0, -5, -6, -7};
  write_file(folder / "a.nii", header.bytes() + ramp<std::int16_t>(kSamples));
  expect_near(last_corner(read_volume(folder / "a.nii")), {5 - 4, 6 - 9, -7 + 16});
}

TEST(ReadVolume, WarnsWhereAShearedSformGivesWayToTheQform)
{
  const TemporaryFolder folder;
  NiftiHeader header;
  header.qform_code = 1;
  header.sform_code = 2;
  header.sform = {1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  write_file(folder / "a.nii", header.bytes() + ramp<std::int16_t>(kSamples));
  const InputVolume input = read_volume(folder / "a.nii");
  ASSERT_EQ(input.warnings.size(), 1U);
  EXPECT_TRUE(contains(input.warnings[0], "sform"));
}

TEST(ReadVolume, RefusesAShearedSformWithoutQform)
{
  const TemporaryFolder folder;
  NiftiHeader header;
  header.sform_code = 2;
  header.sform = {1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  write_file(folder / "a.nii", header.bytes() + ramp<std::int16_t>(kSamples));
  EXPECT_TRUE(contains(refusal(folder / "a.nii"), "sform"));
}

TEST(ReadVolume, WarnsOfAxesThatAreNotOrthogonal)
{
  const TemporaryFolder folder;
  write_file(folder / "a.nrrd", nrrd_header("short", "3 4 5",
                                            "space: LPS\nencoding: raw\nspace origin: (0,0,0)\n"
                                            "space directions: (1,0,0) (0,1,0) (0,0.2,1)\n\n") +
                                    ramp<std::int16_t>(kSamples));
  const InputVolume input = read_volume(folder / "a.nrrd");
  ASSERT_EQ(input.warnings.size(), 1U);
  EXPECT_TRUE(contains(input.warnings[0], "not orthogonal"));
  expect_near(last_corner(input), {2, 3.8, 4});
}

TEST(ReadVolume, NamesItsSourceWithTheDigestOfHeaderAndData)
{
  const TemporaryFolder folder;
  write_file(folder / "data.raw", ramp<std::int16_t>(kSamples));
  write_file(folder / "a.nhdr", nrrd_header("short", "3 4 5", "encoding: raw\ndata file: data.raw\n"));
  const SourceFile source = read_volume(folder / "a.nhdr").source;
  EXPECT_EQ(source.path, (folder / "a.nhdr").string());
  EXPECT_EQ(source.bytes, fs::file_size(folder / "a.nhdr") + 120);
  EXPECT_EQ(source.sha256, sha256_of_files({folder / "a.nhdr", folder / "data.raw"}).sha256);
}

// Refusals.

TEST(ReadVolume, RefusesAMissingFile)
{
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(refusal(folder / "missing.nrrd"), "does not exist"));
}

TEST(ReadVolume, RefusesAFileOfUnknownKind)
{
  const TemporaryFolder folder;
  write_file(folder / "a.jpg", "JFIF");
  EXPECT_TRUE(contains(refusal(folder / "a.jpg"), "allowed: NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd), NIfTI"));
}

TEST(ReadVolume, RefusesAnEmptyFileAndWrongMagic)
{
  const TemporaryFolder folder;
  for (const char *name : {"a.nrrd", "a.nhdr", "a.mha", "a.mhd", "a.nii", "a.nii.gz"}) {
    write_file(folder / name, "");
    EXPECT_TRUE(contains(refusal(folder / name), "does not begin like")) << name;
    write_file(folder / name, std::string(1000, 'x'));
    EXPECT_TRUE(contains(refusal(folder / name), "does not begin like")) << name;
  }
}

TEST(ReadVolume, RefusesADamagedHeader)
{
  const TemporaryFolder folder;
  write_file(folder / "a.nrrd", "NRRD0004\ntype: shrt\ndimension: 3\nsizes: 3 4 5\nencoding: raw\n\n");
  EXPECT_TRUE(contains(refusal(folder / "a.nrrd"), "header cannot be read as NRRD"));
  write_file(folder / "a.mha", "ObjectType = Image\nNDims = 3\n");
  EXPECT_TRUE(contains(refusal(folder / "a.mha"), "ElementDataFile"));
  write_file(folder / "b.mha", meta_header("MET_NONSENSE", "3 4 5", "") + ramp<std::int16_t>(kSamples));
  refusal(folder / "b.mha");
}

TEST(ReadVolume, RefusesHeadersOnWhichTheLibrariesHangOrPrint)
{
  const TemporaryFolder folder;
  for (const char *axes : {"-3", "0", "11"}) {
    write_file(folder / "a.mha", std::string("ObjectType = Image\nNDims = ") + axes +
                                     "\nBinaryData = True\nOffset = 0 0 0\nDimSize = 3 4 5\n"
                                     "ElementType = MET_SHORT\nElementDataFile = LOCAL\n" +
                                     ramp<std::int16_t>(kSamples));
    EXPECT_TRUE(contains(refusal(folder / "a.mha"), "NDims")) << axes;
  }
  NiftiHeader header;
  header.datatype = 5;
  write_file(folder / "a.nii", header.bytes() + ramp<std::int16_t>(kSamples));
  EXPECT_TRUE(contains(refusal(folder / "a.nii"), "damaged NIfTI header"));
}

TEST(ReadVolume, RefusesEveryTruncation)
{
  const TemporaryFolder folder;
  const std::string data = ramp<std::int16_t>(kSamples);
  const std::string packed = zlib(data);
  const std::string nifti = NiftiHeader{}.bytes() + data;
  const std::vector<std::pair<std::string, std::string>> files = {
      {"raw.nrrd", nrrd_header("short", "3 4 5", "encoding: raw\n\n") + data},
      {"gzip.nrrd", nrrd_header("short", "3 4 5", "encoding: gzip\n\n") + gzip(data)},
      {"raw.mha", meta_header("MET_SHORT", "3 4 5", "") + data},
      {"z.mha", meta_header("MET_SHORT", "3 4 5",
                            "CompressedData = True\nCompressedDataSize = " + std::to_string(packed.size()) + "\n") +
                    packed},
      {"raw.nii", nifti},
      {"gzip.nii.gz", gzip(nifti)},
  };
  for (const auto &[name, whole] : files) {
    write_file(folder / name, whole);
    expect_ramp(read_volume(folder / name));
    for (std::size_t size = 0; size < whole.size(); size += size + 20 < whole.size() ? 7 : 1) {
      write_file(folder / name, whole.substr(0, size));
      ASSERT_NE(refusal(folder / name), "") << name << " cut to " << size << " of " << whole.size();
    }
  }
}

TEST(ReadVolume, RefusesDamagedCompression)
{
  const TemporaryFolder folder;
  const std::string header = nrrd_header("short", "3 4 5", "encoding: gzip\n\n");
  const std::string nifti = gzip(NiftiHeader{}.bytes() + ramp<std::int16_t>(kSamples));
  std::string damaged = nifti;
  damaged[nifti.size() - 6] ^= 1; // the checksum
  write_file(folder / "a.nii.gz", damaged);
  EXPECT_TRUE(contains(refusal(folder / "a.nii.gz"), "damaged"));
  write_file(folder / "a.nrrd", header + std::string(100, 'x'));
  EXPECT_TRUE(contains(refusal(folder / "a.nrrd"), "damaged"));
}

TEST(ReadVolume, RefusesAShortOrMissingDataFile)
{
  const TemporaryFolder folder;
  write_file(folder / "a.nhdr", nrrd_header("short", "3 4 5", "encoding: raw\nbyte skip: 1\ndata file: data.raw\n"));
  EXPECT_TRUE(contains(refusal(folder / "a.nhdr"), "data.raw does not exist"));
  write_file(folder / "data.raw", ramp<std::int16_t>(kSamples));
  EXPECT_TRUE(contains(refusal(folder / "a.nhdr"), "119 bytes of samples in data.raw where the header announces 120"));
  write_file(folder / "a.mhd", meta_header("MET_SHORT", "3 4 5", "", "nothing.raw"));
  EXPECT_TRUE(contains(refusal(folder / "a.mhd"), "nothing.raw does not exist"));
}

TEST(ReadVolume, RefusesAFilePatternThatIsNotOneInteger)
{
  const TemporaryFolder folder;
  for (const char *pattern : {"a%s.raw 1 5 1", "a%d%d.raw 1 5 1", "a%9999d.raw 1 5 1", "a%d.raw 1 999999999 1",
                              "a%n.raw 1 5 1", "a%d.raw 1 5 0"}) {
    write_file(folder / "a.mhd", meta_header("MET_SHORT", "3 4 5", "", pattern));
    EXPECT_TRUE(contains(refusal(folder / "a.mhd"), "pattern")) << pattern;
  }
}

TEST(ReadVolume, RefusesVectorsColoursAndComplexNumbers)
{
  const TemporaryFolder folder;
  write_file(folder / "rgb.nrrd",
             nrrd_header("uint8", "3 3 4 5", "kinds: RGB-color domain domain domain\nencoding: raw\n\n") +
                 ramp<std::uint8_t>(180));
  write_file(folder / "vector.nrrd",
             nrrd_header("uint8", "3 3 4 5", "kinds: vector domain domain domain\nencoding: raw\n\n") +
                 ramp<std::uint8_t>(180));
  write_file(folder / "rgb.mha",
             meta_header("MET_UCHAR", "3 4 5", "ElementNumberOfChannels = 3\n") + ramp<std::uint8_t>(180));
  NiftiHeader rgb;
  rgb.datatype = 128;
  rgb.bits = 24;
  write_file(folder / "rgb.nii", rgb.bytes() + ramp<std::uint8_t>(180));
  NiftiHeader complex;
  complex.datatype = 32;
  complex.bits = 64;
  write_file(folder / "complex.nii", complex.bytes() + ramp<float>(120));
  for (const char *file : {"rgb.nrrd", "vector.nrrd", "rgb.mha", "rgb.nii", "complex.nii"})
    EXPECT_TRUE(contains(refusal(folder / file), "allowed: one scalar per sample")) << file;
}

TEST(ReadVolume, RefusesOtherThanThreeDimensions)
{
  const TemporaryFolder folder;
  const std::string data = ramp<std::int16_t>(120);
  NiftiHeader header;
  header.sizes = {3, 4, 5, 2};
  write_file(folder / "4.nii", header.bytes() + data);
  header.sizes = {12, 10};
  write_file(folder / "2.nii", header.bytes() + data);
  write_file(folder / "4.nrrd", nrrd_header("short", "3 4 5 2", "encoding: raw\n\n") + data);
  write_file(folder / "2.nrrd", nrrd_header("short", "12 10", "encoding: raw\n\n") + data);
  write_file(folder / "4.mha", meta_header("MET_SHORT", "3 4 5 2", "") + data);
  write_file(folder / "2.mha", meta_header("MET_SHORT", "12 10", "") + data);
  for (const char *file : {"4.nii", "4.nrrd", "4.mha"})
    EXPECT_TRUE(contains(refusal(folder / file), "found a 4-D image (3 x 4 x 5 x 2); allowed: a 3-D volume")) << file;
  for (const char *file : {"2.nii", "2.nrrd", "2.mha"})
    EXPECT_TRUE(contains(refusal(folder / file), "found a 2-D image (12 x 10)")) << file;
}

TEST(ReadVolume, RefusesFewerThanTwoSamplesOnAnAxis)
{
  const TemporaryFolder folder;
  for (const char *sizes : {"1 12 5", "12 1 5", "12 5 1"}) {
    write_file(folder / "a.nrrd", nrrd_header("short", sizes, "encoding: raw\n\n") + ramp<std::int16_t>(kSamples));
    EXPECT_TRUE(contains(refusal(folder / "a.nrrd"), "allowed: 2 or more on each axis")) << sizes;
  }
}

TEST(ReadVolume, RefusesSpacingsThatAreNotPositiveAndFinite)
{
  const TemporaryFolder folder;
  for (const char *spacing : {"0", "-1", "inf"}) {
    SCOPED_TRACE(spacing);
    const std::string data = ramp<std::int16_t>(kSamples);
    write_file(folder / "a.mha",
               meta_header("MET_SHORT", "3 4 5", std::string("ElementSpacing = 1 ") + spacing + " 1\n") + data);
    refusal(folder / "a.mha");
    write_file(folder / "a.nrrd",
               nrrd_header("short", "3 4 5", std::string("spacings: 1 ") + spacing + " 1\nencoding: raw\n\n") + data);
    refusal(folder / "a.nrrd");
  }
}

TEST(ReadVolume, RefusesASingularDirection)
{
  const TemporaryFolder folder;
  write_file(folder / "a.nrrd", nrrd_header("short", "3 4 5",
                                            "space: LPS\nencoding: raw\nspace origin: (0,0,0)\n"
                                            "space directions: (1,0,0) (0,1,0) (1,1,0)\n\n") +
                                    ramp<std::int16_t>(kSamples));
  EXPECT_TRUE(contains(refusal(folder / "a.nrrd"), "singular direction"));
  write_file(folder / "a.mha",
             meta_header("MET_SHORT", "3 4 5", "TransformMatrix = 1 0 0 1 0 0 0 0 1\n") + ramp<std::int16_t>(kSamples));
  EXPECT_TRUE(contains(refusal(folder / "a.mha"), "singular direction"));
}

TEST(ReadVolume, CountsSamplesThatAreNotFinite)
{
  const TemporaryFolder folder;
  std::vector<float> samples(kSamples, 1.0F);
  samples[20] = std::numeric_limits<float>::quiet_NaN();
  write_file(folder / "a.nrrd", nrrd_header("float", "3 4 5", "encoding: raw\n\n") + bytes_of(samples));
  EXPECT_TRUE(contains(refusal(folder / "a.nrrd"), "found 1 sample that is not finite, the first at index (2, 2, 1)"));
  samples[50] = std::numeric_limits<float>::infinity();
  write_file(folder / "a.nrrd", nrrd_header("float", "3 4 5", "encoding: raw\n\n") + bytes_of(samples));
  EXPECT_TRUE(contains(refusal(folder / "a.nrrd"), "found 2 samples that are not finite"));
}

TEST(ReadVolume, AsksTheCallerBeforeItTakesMemory)
{
  const TemporaryFolder folder;
  write_file(folder / "a.nrrd", nrrd_header("short", "3 4 5", "encoding: raw\n\n") + ramp<std::int16_t>(kSamples));
  ReadOptions options;
  options.check_grid = [](const Grid &grid) { EXPECT_EQ(grid.sample_count(), 60); };
  expect_ramp(read_volume(folder / "a.nrrd", options));
  const std::string message = (folder / "a.nrrd").string() + ": found too much; allowed: less";
  options.check_grid = [&](const Grid &) { throw InputError(message); };
  EXPECT_TRUE(contains(refusal(folder / "a.nrrd", options), "found too much"));
}

TEST(ReadVolume, RefusesSizesThatAreNotThereWithoutTakingMemory)
{
  const TemporaryFolder folder;
  for (const char *sizes : {"100000 100000 100000", "4000000000 4000000000 4000000000"})
    for (const char *encoding : {"raw", "gzip"}) {
      SCOPED_TRACE(std::string(sizes) + " " + encoding);
      const std::string data = ramp<std::int16_t>(kSamples);
      write_file(folder / "a.nrrd", nrrd_header("short", sizes, std::string("encoding: ") + encoding + "\n\n") +
                                        (encoding[0] == 'g' ? gzip(data) : data));
      refusal(folder / "a.nrrd");
    }
}

} // namespace
} // namespace volsurf
