#include "volsurf/io/write_segmentation.h"

#include "io/meshes.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <itkMetaDataObject.h>
#include <itkNrrdImageIO.h>

#include <cmath>

namespace volsurf {
namespace {

using namespace test;

double distance(const std::array<double, 3> &a, const std::array<double, 3> &b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

LabelVolume three_labels()
{
  LabelVolume labels;
  labels.grid.size = {3, 2, 2};
  labels.labels = {0, 0, 300, 300, 0, 7, 7, 7, 0, 0, 0, 0};
  return labels;
}

/// What Slicer's reader, which is ITK's, finds under a key.
std::string value_of(const std::filesystem::path &file, const std::string &key)
{
  const auto io = itk::NrrdImageIO::New();
  io->SetFileName(file.string());
  io->ReadImageInformation();
  std::string value = "no such key";
  itk::ExposeMetaData<std::string>(io->GetMetaDataDictionary(), key, value);
  return value;
}

TEST(WriteSegmentation, ItkFindsEachFieldInItsDictionary)
{
  const TemporaryFolder folder;
  const auto file = folder / "a.seg.nrrd";
  write_segmentation(three_labels(), {{7, "region 7 (3 ml)"}, {300, "liver | left"}}, file, provenance());
  EXPECT_EQ(value_of(file, "Segment0_ID"), "region_7");
  EXPECT_EQ(value_of(file, "Segment0_Name"), "region 7 (3 ml)");
  EXPECT_EQ(value_of(file, "Segment0_LabelValue"), "7");
  EXPECT_EQ(value_of(file, "Segment1_Name"), "liver | left");
  EXPECT_EQ(value_of(file, "Segment1_LabelValue"), "300");
  EXPECT_EQ(value_of(file, "Segment1_Extent"), "0 2 0 1 0 1");
  EXPECT_EQ(value_of(file, "Segment2_ID"), "no such key");
  EXPECT_EQ(value_of(file, "Segmentation_ReferenceImageExtentOffset"), "0 0 0");
  EXPECT_EQ(value_of(file, "Version"), provenance().version);
}

TEST(WriteSegmentation, IsTheSameBytesForTheSameInput)
{
  const TemporaryFolder folder;
  for (const char *name : {"a.seg.nrrd", "b.seg.nrrd"})
    write_segmentation(three_labels(), {{7, "a"}, {300, "b"}}, folder / name, provenance());
  EXPECT_EQ(read_file(folder / "a.seg.nrrd"), read_file(folder / "b.seg.nrrd"));
}

TEST(LabelColour, StaysInRangeAndDiffersFromAllOthersOfASegmentation)
{
  for (std::uint32_t a = 1; a <= 255; ++a) {
    const auto colour = label_colour(a);
    for (const double part : colour) {
      EXPECT_GE(part, 0);
      EXPECT_LE(part, 1);
    }
    for (std::uint32_t b = 1; b < a; ++b)
      EXPECT_GT(distance(colour, label_colour(b)), a <= 12 ? 0.2 : 0.002) << a << " and " << b;
  }
}

TEST(LabelColour, NeighboursInNumberAreFarApart)
{
  for (std::uint32_t label = 2; label <= 1000; ++label)
    EXPECT_GT(distance(label_colour(label), label_colour(label - 1)), 0.3) << label;
}

} // namespace
} // namespace volsurf
