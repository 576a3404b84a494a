// Surfaces as they are found: written by this program, by others, or broken.
#include "volsurf/io/read_mesh.h"

#include "io/meshes.h"
#include "support/contains.h"
#include "support/solids.h"
#include "support/temporary_folder.h"
#include "volsurf/core/error.h"
#include "volsurf/io/write_mesh.h"

#include <gtest/gtest.h>

#include <limits>

namespace fs = std::filesystem;

namespace volsurf::test {
namespace {

class ReadMesh : public testing::Test {
protected:
  fs::path file(const std::string &name, const std::string &bytes) const
  {
    write_file(folder / name, bytes);
    return folder / name;
  }

  /// The message of the InputError, which must name the file and be one line.
  std::string refusal(const fs::path &path) const
  {
    try {
      read_mesh(path);
    } catch (const InputError &error) {
      const std::string message = error.what();
      EXPECT_EQ(message.rfind(path.string() + ": ", 0), 0U) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message;
    }
    ADD_FAILURE() << path << " was read";
    return "";
  }

  const TemporaryFolder folder;
};

constexpr char kObjTriangle[] = "v 1 2 3\nv 2 2 3\nv 1 4 3\nf 1 2 3\n";

TEST_F(ReadMesh, GivesBackWhatWasWrittenInEachFormatAndFrame)
{
  const Mesh mesh = sphere_mesh({10, -20, 30}, 7, 2);
  for (const std::string name : {"a.vtp", "a.STL", "a.ply", "a.obj"})
    for (const Frame frame : {Frame::lps, Frame::ras}) {
      write_mesh(mesh, output_kind_of(name), folder / name, provenance(), frame);
      const InputMesh input = read_mesh(folder / name);
      EXPECT_EQ(input.frame_mark, frame) << name;
      ASSERT_EQ(input.mesh.triangles.size(), mesh.triangles.size()) << name;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i)
          EXPECT_EQ(input.mesh.points[input.mesh.triangles[t][i]], mesh.points[mesh.triangles[t][i]]) << name;
    }
}

TEST_F(ReadMesh, KeepsTheArraysOfAVtp)
{
  write_mesh(small_mesh(), OutputKind::vtp, folder / "a.vtp", provenance(), Frame::lps);
  const Mesh mesh = read_mesh(folder / "a.vtp").mesh;
  EXPECT_EQ(mesh.region_a, small_mesh().region_a);
  EXPECT_EQ(mesh.persistence, small_mesh().persistence);
}

TEST_F(ReadMesh, TakesTheAssumedFrameWhereTheFileNamesNone)
{
  const fs::path path = file("a.obj", kObjTriangle);
  const InputMesh lps = read_mesh(path);
  EXPECT_FALSE(lps.frame_mark.has_value());
  EXPECT_EQ(lps.mesh.points[1], (Point{2, 2, 3}));
  EXPECT_EQ(read_mesh(path, Frame::ras).mesh.points[1], (Point{-2, -2, 3}));
}

TEST_F(ReadMesh, HonoursTheMarksThatSlicerWrites)
{
  const Point ras_point{-2, -2, 3};
  EXPECT_EQ(read_mesh(file("a.obj", std::string("# 3D Slicer output. SPACE=RAS\n") + kObjTriangle)).mesh.points[1],
            ras_point);
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 1 2 3\nvertex 2 2 3\nvertex 1 4 3\nendloop\n"
                            "endfacet\nendsolid\n";
  EXPECT_EQ(read_mesh(file("a.stl", "solid 3D Slicer output. SPACE=RAS\n" + facet)).mesh.points[1], ras_point);
  EXPECT_FALSE(read_mesh(file("b.stl", "solid nameless\n" + facet)).frame_mark.has_value());
  const std::string ply = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                          "property list uchar int vertex_indices\nend_header\n1 2 3\n2 2 3\n1 4 3\n3 0 1 2\n";
  EXPECT_EQ(read_mesh(file("a.ply", "ply\nformat ascii 1.0\ncomment SPACE=RAS\n" + ply)).mesh.points[1], ras_point);
  EXPECT_TRUE(contains(refusal(file("c.obj", std::string("# SPACE=XYZ\n") + kObjTriangle)), "SPACE=XYZ"));
}

TEST_F(ReadMesh, CutsPolygonsIntoTriangles)
{
  EXPECT_EQ(read_mesh(file("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")).mesh.triangles.size(), 2U);
}

TEST_F(ReadMesh, RefusesWhatIsNoSurface)
{
  EXPECT_TRUE(contains(refusal(file("a.obj", "v 0 0 0\n")), "no triangle"));
  EXPECT_TRUE(
      contains(refusal(file("b.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n")), "not finite, or no point, in line 2"));
  Mesh nowhere = sphere_mesh({0, 0, 0}, 7, 1);
  nowhere.points[3][1] = std::numeric_limits<float>::quiet_NaN();
  for (const std::string name : {"nan.vtp", "nan.stl", "nan.ply"}) {
    write_mesh(nowhere, output_kind_of(name), folder / name, provenance(), Frame::lps);
    EXPECT_TRUE(contains(refusal(folder / name), "not finite")) << name;
  }
  EXPECT_TRUE(contains(refusal(folder / "gone.vtp"), "does not exist"));
  EXPECT_TRUE(contains(refusal(file("a.xyz", "")), ".xyz; allowed: .vtp, .stl, .ply, .obj"));
  for (const std::string name : {"empty.vtp", "empty.stl", "empty.ply", "empty.obj"})
    refusal(file(name, ""));
  for (const std::string name : {"text.vtp", "text.stl", "text.ply"})
    refusal(file(name, "This is no surface.\n"));
}

TEST_F(ReadMesh, RefusesPointsThatDoNotExist)
{
  refusal(file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"));
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
                          "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n1 2 3\n2 2 3\n1 4 "
                          "3\n3 0 1 7\n";
  EXPECT_TRUE(contains(refusal(file("a.ply", ply)), "point 7; allowed: 0 to 2"));
}

TEST_F(ReadMesh, RefusesFilesThatAreCutShort)
{
  for (const std::string name : {"a.vtp", "a.stl", "a.ply"}) {
    write_mesh(sphere_mesh({0, 0, 0}, 7, 3), output_kind_of(name), folder / name, provenance(), Frame::lps);
    const std::string whole = read_file(folder / name);
    refusal(file(name, whole.substr(0, whole.size() * 2 / 3)));
  }
}

} // namespace
} // namespace volsurf::test
