#include "volsurf/io/write_mesh.h"

#include "io/full_disk.h"
#include "io/meshes.h"
#include "support/temporary_folder.h"
#include "volsurf/interop/vtk_mesh.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkSTLReader.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

namespace fs = std::filesystem;

namespace volsurf {
namespace {

using namespace test;

template <typename Reader> Mesh read_back(const fs::path &file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return from_poly_data(*reader->GetOutput());
}

void write(const fs::path &file, const Mesh &mesh = small_mesh(), Frame frame = Frame::lps)
{
  write_mesh(mesh, output_kind_of(file), file, provenance(), frame);
}

std::vector<std::array<Point, 3>> corners(const Mesh &mesh)
{
  std::vector<std::array<Point, 3>> result;
  for (const Triangle &t : mesh.triangles)
    result.push_back({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
  return result;
}

std::string field_text(vtkPolyData &data, const char *name)
{
  auto *array = vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray(name));
  return array != nullptr && array->GetNumberOfValues() == 1 ? array->GetValue(0) : "";
}

TEST(WriteMesh, VtpReadsBackWithAllArrays)
{
  const TemporaryFolder folder;
  write(folder / "a.vtp");
  const Mesh mesh = read_back<vtkXMLPolyDataReader>(folder / "a.vtp");
  const Mesh expected = small_mesh();
  EXPECT_EQ(mesh.points, expected.points);
  EXPECT_EQ(mesh.triangles, expected.triangles);
  EXPECT_EQ(mesh.region_a, expected.region_a);
  EXPECT_EQ(mesh.region_b, expected.region_b);
  EXPECT_EQ(mesh.persistence, expected.persistence);
  EXPECT_EQ(mesh.component, expected.component);
  EXPECT_EQ(mesh.cap, expected.cap);
}

TEST(WriteMesh, VtpSaysItsFrameAndMakingInFieldData)
{
  const TemporaryFolder folder;
  write(folder / "a.vtp", small_mesh(), Frame::ras);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((folder / "a.vtp").c_str());
  reader->Update();
  EXPECT_EQ(field_text(*reader->GetOutput(), "SPACE"), "RAS");
  EXPECT_EQ(field_text(*reader->GetOutput(), "Version"), "volsurf 1.2.3");
  EXPECT_EQ(field_text(*reader->GetOutput(), "Source"), "head.nrrd");
  EXPECT_EQ(field_text(*reader->GetOutput(), "Options"), "--delta 20 --keep 5%");
}

TEST(WriteMesh, VtpIsCompressedAndHasNoAppendedSectionWhichParaViewCannotRead)
{
  const TemporaryFolder folder;
  write(folder / "a.vtp");
  const std::string file = read_file(folder / "a.vtp");
  EXPECT_EQ(file.find("<AppendedData"), std::string::npos);
  EXPECT_NE(file.find("format=\"binary\""), std::string::npos);
  EXPECT_NE(file.find("compressor=\"vtkZLibDataCompressor\""), std::string::npos);
}

TEST(WriteMesh, StlReadsBackAndItsHeaderSaysTheFrame)
{
  const TemporaryFolder folder;
  write(folder / "a.stl");
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName((folder / "a.stl").c_str());
  reader->MergingOff();
  reader->Update();
  EXPECT_EQ(corners(from_poly_data(*reader->GetOutput())), corners(small_mesh()));
  const std::string header = read_file(folder / "a.stl").substr(0, 80);
  EXPECT_EQ(header.rfind("SPACE=LPS; volsurf 1.2.3; head.nrrd", 0), 0U) << header;
}

TEST(WriteMesh, StlCutsAHeaderThatIsTooLong)
{
  const TemporaryFolder folder;
  Provenance longer = provenance();
  longer.source = std::string(500, 'n');
  write_mesh(small_mesh(), OutputKind::stl, folder / "a.stl", longer, Frame::ras);
  EXPECT_EQ(read_file(folder / "a.stl").substr(0, 9), "SPACE=RAS");
  EXPECT_EQ(fs::file_size(folder / "a.stl"), 84U + 2 * 50);
}

TEST(WriteMesh, PlyReadsBackAndItsCommentsSayTheMaking)
{
  const TemporaryFolder folder;
  write(folder / "a.ply");
  const Mesh mesh = read_back<vtkPLYReader>(folder / "a.ply");
  EXPECT_EQ(mesh.points, small_mesh().points);
  EXPECT_EQ(mesh.triangles, small_mesh().triangles);
  const std::string file = read_file(folder / "a.ply");
  for (const char *line : {"\nformat binary_little_endian 1.0\n", "\ncomment SPACE=LPS\n",
                           "\ncomment Version=volsurf 1.2.3\n", "\ncomment Options=--delta 20 --keep 5%\n"})
    EXPECT_NE(file.find(line), std::string::npos) << line;
}

TEST(WriteMesh, ObjReadsBackAndItsCommentsSayTheMaking)
{
  const TemporaryFolder folder;
  write(folder / "a.obj");
  const Mesh mesh = read_back<vtkOBJReader>(folder / "a.obj");
  EXPECT_EQ(mesh.points, small_mesh().points);
  EXPECT_EQ(mesh.triangles, small_mesh().triangles);
  const std::string start =
      "# SPACE=LPS\n# Version=volsurf 1.2.3\n# Source=head.nrrd\n# Options=--delta 20 --keep 5%\n";
  EXPECT_EQ(read_file(folder / "a.obj").substr(0, start.size()), start);
}

TEST(WriteMesh, RasFlipsXAndYInEveryFormat)
{
  const TemporaryFolder folder;
  Mesh turned = small_mesh();
  for (Point &point : turned.points)
    point = {-point[0], -point[1], point[2]};
  for (const char *name : {"a.vtp", "a.ply", "a.stl", "a.obj"})
    write(folder / name, small_mesh(), Frame::ras);
  EXPECT_EQ(read_back<vtkXMLPolyDataReader>(folder / "a.vtp").points, turned.points);
  EXPECT_EQ(read_back<vtkPLYReader>(folder / "a.ply").points, turned.points);
  EXPECT_EQ(read_back<vtkOBJReader>(folder / "a.obj").points, turned.points);
  EXPECT_EQ(corners(read_back<vtkSTLReader>(folder / "a.stl"))[0], corners(turned)[0]);
}

TEST(WriteMesh, LineBreaksInTheProvenanceDoNotBreakHeaders)
{
  const TemporaryFolder folder;
  Provenance odd = provenance();
  odd.source = "two\nlines\r.nrrd";
  for (const char *name : {"a.ply", "a.obj", "a.stl", "a.vtp"})
    write_mesh(small_mesh(), output_kind_of(name), folder / name, odd, Frame::lps);
  EXPECT_EQ(read_back<vtkPLYReader>(folder / "a.ply").points, small_mesh().points);
  EXPECT_EQ(read_back<vtkOBJReader>(folder / "a.obj").points, small_mesh().points);
}

class WriteMeshTo : public testing::TestWithParam<const char *> {};

TEST_P(WriteMeshTo, IsTheSameBytesForTheSameInput)
{
  const TemporaryFolder folder;
  const std::string extension = GetParam();
  write(folder / ("a" + extension), random_mesh(500));
  write(folder / ("b" + extension), random_mesh(500));
  EXPECT_EQ(read_file(folder / ("a" + extension)), read_file(folder / ("b" + extension)));
}

TEST_P(WriteMeshTo, AFullDiskIsNoticed)
{
  expect_full_disk_is_noticed(std::string("a") + GetParam(),
                              [](const fs::path &file) { write(file, random_mesh(2000)); });
}

TEST_P(WriteMeshTo, AMissingFolderIsAnOutputErrorAndPrintsNothing)
{
  const TemporaryFolder folder;
  testing::internal::CaptureStderr();
  EXPECT_THROW(write(folder / (std::string("missing/a") + GetParam())), OutputError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

INSTANTIATE_TEST_SUITE_P(Formats, WriteMeshTo, testing::Values(".vtp", ".stl", ".ply", ".obj"),
                         [](const auto &format) { return std::string(format.param).substr(1); });

TEST(OutputKindOf, FollowsTheExtensionInEitherCase)
{
  EXPECT_EQ(output_kind_of("a/b.vtp"), OutputKind::vtp);
  EXPECT_EQ(output_kind_of("b.STL"), OutputKind::stl);
  EXPECT_EQ(output_kind_of("b.c.ply"), OutputKind::ply);
  EXPECT_EQ(output_kind_of("b.obj"), OutputKind::obj);
  EXPECT_EQ(output_kind_of("b.vdb"), OutputKind::vdb);
}

TEST(OutputKindOf, NamesWhatIsAllowed)
{
  for (const char *path : {"a.vtk", "a", ".stl", "a.stl/"}) {
    try {
      output_kind_of(path);
      ADD_FAILURE() << path;
    } catch (const UsageError &error) {
      EXPECT_NE(std::string(error.what()).find("allowed: .vtp, .stl, .ply, .obj, .vdb"), std::string::npos);
    }
  }
}

} // namespace
} // namespace volsurf
