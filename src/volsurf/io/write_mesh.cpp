#include "volsurf/io/write_mesh.h"

#include "volsurf/core/error.h"
#include "volsurf/interop/quiet_vtk.h"
#include "volsurf/interop/vtk_mesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <charconv>
#include <fstream>
#include <utility>
#include <vector>
#include <vtkCellData.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkSTLWriter.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

namespace fs = std::filesystem;

namespace volsurf {

namespace {

constexpr std::size_t kStlHeaderBytes = 80;

[[noreturn]] void fail(const fs::path &file, const std::string &why)
{
  throw OutputError(file.string() + ": cannot be written: " + why);
}

/// Line breaks would end a comment, and end the header with it.
std::string one_line(std::string text)
{
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return text;
}

std::vector<std::pair<std::string, std::string>> labelled(const Provenance &provenance, Frame frame)
{
  return {{"SPACE", frame_name(frame)},
          {"Version", one_line(provenance.version)},
          {"Source", one_line(provenance.source)},
          {"Options", one_line(provenance.options)}};
}

/// Runs a VTK writer.
template <typename Writer> void run(Writer &writer, const fs::path &file)
{
  const QuietVtk quiet;
  writer.SetFileName(file.c_str());
  const int success = writer.Write();
  const unsigned long code = writer.GetErrorCode();
  if (code != vtkErrorCode::NoError)
    fail(file, vtkErrorCode::GetStringFromErrorCode(code));
  if (success == 0)
    fail(file, "the writer failed");
}

std::uintmax_t size_of(const fs::path &file)
{
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(file, error);
  if (error)
    fail(file, error.message());
  return bytes;
}

/// VTK's writers do not look at the result of their last flush, so a disk that is full by a few bytes goes unseen.
void check_size(const fs::path &file, std::uintmax_t expected)
{
  const std::uintmax_t found = size_of(file);
  if (found != expected)
    fail(file, "only " + std::to_string(found) + " of " + std::to_string(expected) + " bytes fit; is the disk full?");
}

void add_field_data(vtkPolyData &data, const Provenance &provenance, Frame frame)
{
  for (const auto &[name, value] : labelled(provenance, frame)) {
    vtkNew<vtkStringArray> array;
    array->SetName(name.c_str());
    array->InsertNextValue(value);
    data.GetFieldData()->AddArray(array);
  }
}

void add_point_arrays(const std::vector<PointArray> &arrays, vtkPolyData &data)
{
  for (const PointArray &array : arrays) {
    vtkNew<vtkFloatArray> values;
    values->SetName(array.name.c_str());
    values->SetNumberOfValues(static_cast<vtkIdType>(array.values.size()));
    std::copy(array.values.begin(), array.values.end(), values->GetPointer(0));
    data.GetPointData()->AddArray(values);
  }
  if (!arrays.empty())
    data.GetPointData()->SetActiveScalars(arrays.front().name.c_str());
}

/// Writes a mesh, with the arrays that are to go with it, as VTP.
void write_poly_data(vtkPolyData &data, const fs::path &file, const Provenance &provenance, Frame frame)
{
  add_field_data(data, provenance, frame);
  const QuietVtk quiet;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(&data);
  writer->SetDataModeToBinary(); // ParaView 5.11 with Debian's present expat reads no appended data
  writer->SetCompressorTypeToZLib();
  writer->SetCompressionLevel(1); // on 3.4 million triangles 4 % larger than at 5, in half of the time
  writer->SetByteOrderToLittleEndian();
  writer->WriteToOutputStringOn(); // in this mode the writer breaks down on a full disk
  if (writer->Write() == 0)
    fail(file, "the writer failed");
  const std::string text = writer->GetOutputString();
  std::ofstream stream(file, std::ios::binary);
  stream.write(text.data(), static_cast<std::streamsize>(text.size())).flush();
  if (!stream)
    fail(file, "its end is missing; is the disk full?");
}

void write_stl(const Mesh &mesh, const fs::path &file, const Provenance &provenance, Frame frame)
{
  std::string header = "SPACE=" + frame_name(frame) + "; " + provenance.version + "; " + provenance.source;
  header = one_line(header);
  header.resize(kStlHeaderBytes, ' ');
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputData(to_poly_data(mesh, frame));
  writer->SetFileTypeToBinary();
  writer->SetHeader(header.c_str());
  run(*writer, file);
  check_size(file, kStlHeaderBytes + 4 + 50 * mesh.triangles.size());
}

std::uintmax_t ply_header_bytes(const fs::path &file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  while (std::getline(stream, line))
    if (line == "end_header")
      return static_cast<std::uintmax_t>(stream.tellg());
  fail(file, "its header is incomplete; is the disk full?");
}

void write_ply(const Mesh &mesh, const fs::path &file, const Provenance &provenance, Frame frame)
{
  vtkNew<vtkPLYWriter> writer;
  writer->SetInputData(to_poly_data(mesh, frame));
  writer->SetFileTypeToBinary();
  writer->SetDataByteOrderToLittleEndian();
  for (const auto &[name, value] : labelled(provenance, frame))
    writer->AddComment(std::string(name).append("=").append(value));
  run(*writer, file);
  const std::uintmax_t point_bytes = 12 * mesh.points.size();
  const std::uintmax_t triangle_bytes = 13 * mesh.triangles.size();
  check_size(file, ply_header_bytes(file) + point_bytes + triangle_bytes);
}

/// Shortest decimal form that reads back as the same float.
void append(std::string &text, float value)
{
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  assert(error == std::errc());
  text.append(digits.data(), end);
}

/// Not by vtkOBJWriter, which writes no comments and never looks whether the bytes arrived.
void write_obj(const Mesh &mesh, const fs::path &file, const Provenance &provenance, Frame frame)
{
  std::ofstream stream(file, std::ios::binary);
  for (const auto &[name, value] : labelled(provenance, frame))
    stream << "# " << name << "=" << value << "\n";
  std::string line;
  for (const Point &point : mesh.points) {
    line = "v";
    for (const float coordinate : to_frame(point, frame))
      append(line += ' ', coordinate);
    stream << (line += '\n');
  }
  for (const Triangle &triangle : mesh.triangles) {
    line = "f";
    for (const PointId id : triangle)
      line += ' ' + std::to_string(std::uint64_t{id} + 1);
    stream << (line += '\n');
  }
  stream.close();
  if (!stream)
    fail(file, "is the disk full?");
}

} // namespace

OutputKind output_kind_of(const fs::path &path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".vtp")
    return OutputKind::vtp;
  if (extension == ".stl")
    return OutputKind::stl;
  if (extension == ".ply")
    return OutputKind::ply;
  if (extension == ".obj")
    return OutputKind::obj;
  if (extension == ".vdb")
    return OutputKind::vdb;
  throw UsageError(path.string() + ": found " + (extension.empty() ? "no extension" : "the extension " + extension) +
                   "; allowed: .vtp, .stl, .ply, .obj, .vdb");
}

void write_mesh(const Mesh &mesh, OutputKind kind, const fs::path &file, const Provenance &provenance, Frame frame)
{
  switch (kind) {
  case OutputKind::vtp:
    return write_vtp(mesh, {}, file, provenance, frame);
  case OutputKind::stl:
    return write_stl(mesh, file, provenance, frame);
  case OutputKind::ply:
    return write_ply(mesh, file, provenance, frame);
  case OutputKind::obj:
    return write_obj(mesh, file, provenance, frame);
  case OutputKind::vdb:
    break;
  }
  assert(false && "a VDB file holds no mesh");
}

void write_vtp(const Mesh &mesh, const std::vector<PointArray> &arrays, const fs::path &file,
               const Provenance &provenance, Frame frame)
{
  const vtkSmartPointer<vtkPolyData> data = to_poly_data(mesh, frame);
  add_cell_arrays(mesh, *data);
  if (arrays.empty())
    data->GetCellData()->SetActiveScalars("Persistence");
  add_point_arrays(arrays, *data);
  write_poly_data(*data, file, provenance, frame);
}

} // namespace volsurf
