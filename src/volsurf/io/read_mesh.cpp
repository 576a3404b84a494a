#include "volsurf/io/read_mesh.h"

#include "volsurf/core/error.h"
#include "volsurf/interop/vtk_mesh.h"
#include "volsurf/io/mesh_file_size.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPLYReader.h>
#include <vtkSTLReader.h>
#include <vtkStringArray.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

namespace fs = std::filesystem;

namespace volsurf {

namespace {

[[noreturn]] void fail(const fs::path &path, const std::string &found, const std::string &allowed)
{
  throw InputError(path.string() + ": found " + found + "; allowed: " + allowed);
}

std::string lower_extension(const fs::path &path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// Takes VTK's messages instead of stderr: some readers say only there that a file is cut short.
class MessageLog : public vtkOutputWindow {
public:
  static MessageLog *New() { VTK_STANDARD_NEW_BODY(MessageLog); }
  vtkTypeMacro(MessageLog, vtkOutputWindow) void DisplayText(const char *text) override
  {
    if (first.empty())
      first = text;
  }

  std::string first;
};

/// While it lives, VTK's messages go to its log.
class CaughtMessages {
public:
  CaughtMessages() : before_(vtkOutputWindow::GetInstance()), verbosity_(vtkLogger::GetCurrentVerbosityCutoff())
  {
    vtkOutputWindow::SetInstance(log_);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // it prints beside the window
  }
  ~CaughtMessages()
  {
    vtkLogger::SetStderrVerbosity(verbosity_);
    vtkOutputWindow::SetInstance(before_);
  }
  CaughtMessages(const CaughtMessages &) = delete;
  CaughtMessages &operator=(const CaughtMessages &) = delete;

  /// The last line of the first message, without "ERROR: In ..., line ..." and the object's address; "" for none.
  std::string reason() const
  {
    std::string text = log_->first;
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0)
      text.pop_back();
    const auto line = text.find_last_of('\n');
    text = line == std::string::npos ? text : text.substr(line + 1);
    const auto colon = text.find("): ");
    return colon == std::string::npos ? text : text.substr(colon + 3);
  }

private:
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkLogger::Verbosity verbosity_;
  vtkNew<MessageLog> log_;
};

template <typename Reader> vtkSmartPointer<vtkPolyData> read_by(const fs::path &path)
{
  const CaughtMessages messages;
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!messages.reason().empty() || reader->GetErrorCode() != 0)
    fail(path, "no complete surface (" + messages.reason() + ")", "a complete " + lower_extension(path) + " file");
  return reader->GetOutput();
}

/// vtkOBJReader takes what it cannot read for 0.
void check_obj_numbers(const fs::path &path)
{
  std::ifstream stream(path);
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.rfind("v ", 0) != 0)
      continue;
    const char *text = line.c_str() + 1;
    for (int axis = 0; axis < 3; ++axis) {
      char *end = nullptr;
      const float value = std::strtof(text, &end);
      if (end == text || !std::isfinite(value))
        fail(path, "a point that is not finite, or no point, in line " + std::to_string(number), "three numbers");
      text = end;
    }
  }
}

vtkSmartPointer<vtkPolyData> read_poly_data(const fs::path &path)
{
  const std::string extension = lower_extension(path);
  if (extension == ".vtp")
    return read_by<vtkXMLPolyDataReader>(path);
  if (extension == ".stl") {
    check_stl_size(path);
    return read_by<vtkSTLReader>(path);
  }
  if (extension == ".ply") {
    check_ply_size(path);
    return read_by<vtkPLYReader>(path);
  }
  check_obj_numbers(path);
  return read_by<vtkOBJReader>(path);
}

/// The text before the data: an STL's first 80 bytes, a PLY's header, the lines that begin an OBJ file with '#'.
std::string header_text(const fs::path &path)
{
  constexpr std::size_t kStlHeaderBytes = 80;
  const std::string extension = lower_extension(path);
  std::ifstream stream(path, std::ios::binary);
  std::string text;
  if (extension == ".stl") {
    text.resize(kStlHeaderBytes);
    stream.read(text.data(), kStlHeaderBytes);
    return text;
  }
  const std::string last = extension == ".ply" ? "end_header" : "v ";
  for (std::string line; std::getline(stream, line) && line.rfind(last, 0) != 0;)
    if (line.rfind("comment", 0) == 0 || line.rfind('#', 0) == 0)
      text += line + "\n";
  return text;
}

/// What stands behind SPACE=, or in the field data array SPACE; "" where there is neither.
std::string space_of(const fs::path &path, vtkPolyData &data)
{
  if (auto *const array = vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray("SPACE")))
    return array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : "";
  if (lower_extension(path) == ".vtp")
    return "";
  const std::string text = header_text(path);
  const auto at = text.find("SPACE=");
  if (at == std::string::npos)
    return "";
  const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at + 6);
  return {begin, std::find_if(begin, text.end(), [](unsigned char c) { return std::isalpha(c) == 0; })};
}

std::optional<Frame> frame_mark(const fs::path &path, vtkPolyData &data)
{
  const std::string space = space_of(path, data);
  if (space.empty())
    return std::nullopt;
  if (space != "LPS" && space != "RAS")
    fail(path, "the frame SPACE=" + space, "LPS, RAS");
  return space == "RAS" ? Frame::ras : Frame::lps;
}

/// Filters take a file's ids on trust.
void check_ids(const fs::path &path, vtkPolyData &data)
{
  for (vtkCellArray *cells : {data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips()}) {
    vtkIdType count = 0;
    const vtkIdType *ids = nullptr;
    for (cells->InitTraversal(); cells->GetNextCell(count, ids) != 0;)
      for (vtkIdType i = 0; i < count; ++i)
        if (ids[i] < 0 || ids[i] >= data.GetNumberOfPoints())
          fail(path, "a triangle with point " + std::to_string(ids[i]),
               "0 to " + std::to_string(data.GetNumberOfPoints() - 1));
  }
}

void check_points(const fs::path &path, const Mesh &mesh)
{
  const auto is_bad = [](const Point &p) {
    return !std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]);
  };
  const auto bad = std::count_if(mesh.points.begin(), mesh.points.end(), is_bad);
  if (bad > 0)
    fail(path, std::to_string(bad) + (bad == 1 ? " point that is" : " points that are") + " not finite",
         "finite coordinates");
}

Mesh triangles_of(vtkPolyData &data)
{
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->SetInputData(&data);
  triangulate->Update();
  return from_poly_data(*triangulate->GetOutput());
}

InputMesh read(const fs::path &path, Frame assumed)
{
  const vtkSmartPointer<vtkPolyData> data = read_poly_data(path);
  check_ids(path, *data);
  InputMesh input;
  input.frame_mark = frame_mark(path, *data);
  input.mesh = triangles_of(*data);
  if (input.mesh.triangles.empty())
    fail(path, "no triangle", "a surface");
  check_points(path, input.mesh);
  const Frame frame = input.frame_mark.value_or(assumed);
  for (Point &point : input.mesh.points)
    point = to_frame(point, frame); // a half turn is its own inverse
  return input;
}

} // namespace

bool has_mesh_extension(const fs::path &path)
{
  const std::string extension = lower_extension(path);
  return extension == ".vtp" || extension == ".stl" || extension == ".ply" || extension == ".obj";
}

InputMesh read_mesh(const fs::path &path, Frame assumed)
{
  if (!has_mesh_extension(path))
    fail(path, path.has_extension() ? "the extension " + path.extension().string() : "no extension",
         ".vtp, .stl, .ply, .obj");
  std::error_code error;
  if (!fs::exists(path, error))
    throw InputError(path.string() + ": the file does not exist");
  if (!fs::is_regular_file(path, error))
    fail(path, "a folder, device or pipe", "a file");
  if (!std::ifstream(path))
    throw InputError(path.string() + ": the file cannot be opened for reading");
  try {
    return read(path, assumed);
  } catch (const std::bad_alloc &) {
    fail(path, "a surface that does not fit into memory", "a smaller one");
  } catch (const std::length_error &) {
    fail(path, "a surface that does not fit into memory", "a smaller one");
  }
}

} // namespace volsurf
