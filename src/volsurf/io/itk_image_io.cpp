#include "volsurf/io/itk_image_io.h"

#include "volsurf/core/error.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace fs = std::filesystem;

namespace volsurf {

namespace {

using Component = itk::IOComponentEnum;

[[noreturn]] void fail(const fs::path &path, const std::string &found, const std::string &allowed)
{
  throw InputError(path.string() + ": found " + found + "; allowed: " + allowed);
}

void check_scalar(const itk::ImageIOBase &io, const fs::path &path)
{
  if (io.GetPixelType() == itk::IOPixelEnum::SCALAR && io.GetNumberOfComponents() == 1)
    return;
  fail(path,
       "pixels of kind " + itk::ImageIOBase::GetPixelTypeAsString(io.GetPixelType()) + " with " +
           std::to_string(io.GetNumberOfComponents()) + " components",
       "one scalar per sample");
}

std::string sizes_text(const itk::ImageIOBase &io)
{
  std::string text;
  for (unsigned int axis = 0; axis < io.GetNumberOfDimensions(); ++axis)
    text += (axis > 0 ? " x " : "") + std::to_string(io.GetDimensions(axis));
  return text;
}

void check_dimensions(const itk::ImageIOBase &io, const fs::path &path)
{
  unsigned int axes = io.GetNumberOfDimensions();
  while (axes > 3 && io.GetDimensions(axes - 1) == 1)
    --axes;
  if (axes != 3)
    fail(path, "a " + std::to_string(axes) + "-D image (" + sizes_text(io) + ")", "a 3-D volume");
}

void check_geometry(const Grid &grid, const fs::path &path)
{
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(grid.spacing_mm[axis] > 0) || !std::isfinite(grid.spacing_mm[axis]))
      fail(path, "a spacing of " + std::to_string(grid.spacing_mm[axis]) + " mm on axis " + std::to_string(axis),
           "positive and finite spacings");
    if (!std::isfinite(grid.origin_mm[axis]))
      fail(path, "an origin that is not finite", "finite coordinates");
    for (const double cosine : grid.direction[axis])
      largest = std::max(largest, std::isfinite(cosine) ? std::abs(cosine) : 1e300);
  }
  constexpr double kSmallestDeterminant = 1e-6;
  if (largest > 1e6 || !(std::abs(determinant(grid.direction)) > kSmallestDeterminant))
    fail(path, "a singular direction matrix", "three independent axes");
}

template <typename Value> void convert(const std::byte *bytes, float *samples, std::size_t count)
{
  const auto *values = reinterpret_cast<const Value *>(bytes);
  std::transform(values, values + count, samples, [](Value value) { return static_cast<float>(value); });
}

void convert(Component type, const std::byte *bytes, float *samples, std::size_t count)
{
  switch (type) {
  case Component::UCHAR:
    return convert<unsigned char>(bytes, samples, count);
  case Component::CHAR:
    return convert<signed char>(bytes, samples, count);
  case Component::USHORT:
    return convert<unsigned short>(bytes, samples, count);
  case Component::SHORT:
    return convert<short>(bytes, samples, count);
  case Component::UINT:
    return convert<unsigned int>(bytes, samples, count);
  case Component::INT:
    return convert<int>(bytes, samples, count);
  case Component::ULONG:
    return convert<unsigned long>(bytes, samples, count);
  case Component::LONG:
    return convert<long>(bytes, samples, count);
  case Component::ULONGLONG:
    return convert<unsigned long long>(bytes, samples, count);
  case Component::LONGLONG:
    return convert<long long>(bytes, samples, count);
  case Component::FLOAT:
    return convert<float>(bytes, samples, count);
  case Component::DOUBLE:
    return convert<double>(bytes, samples, count);
  default:
    throw InputError("found samples of a type that ITK does not know; allowed: integers and floats of 8 to 64 bits");
  }
}

itk::ImageIORegion whole_region(const itk::ImageIOBase &io)
{
  itk::ImageIORegion region(io.GetNumberOfDimensions());
  for (unsigned int axis = 0; axis < io.GetNumberOfDimensions(); ++axis) {
    region.SetIndex(axis, 0);
    region.SetSize(axis, io.GetDimensions(axis));
  }
  return region;
}

} // namespace

QuietItk::QuietItk()
    : warnings_(itk::Object::GetGlobalWarningDisplay()), out_(std::cout.rdbuf(swallowed_.rdbuf())),
      error_(std::cerr.rdbuf(swallowed_.rdbuf()))
{
  itk::Object::SetGlobalWarningDisplay(false);
}

QuietItk::~QuietItk()
{
  std::cout.rdbuf(out_);
  std::cerr.rdbuf(error_);
  itk::Object::SetGlobalWarningDisplay(warnings_);
}

std::string one_line(const itk::ExceptionObject &error)
{
  std::istringstream words(error.GetDescription());
  std::string text;
  for (std::string word; words >> word;) {
    const bool is_noise = word == "ITK" || word == "ERROR:" || word.find("(0x") != std::string::npos;
    if (!is_noise)
      text += (text.empty() ? "" : " ") + word;
  }
  const auto last = text.find_last_not_of(" .");
  return last == std::string::npos ? "no reason given" : text.substr(0, last + 1);
}

void read_information(itk::ImageIOBase &io, const fs::path &path, const std::string &format)
{
  io.SetFileName(path.string());
  try {
    io.ReadImageInformation();
  } catch (const itk::ExceptionObject &error) {
    throw InputError(path.string() + ": the header cannot be read as " + format + ": " + one_line(error));
  }
}

Grid grid_of(const itk::ImageIOBase &io)
{
  Grid grid;
  const unsigned int axes = std::min(io.GetNumberOfDimensions(), 3U);
  grid.size = {1, 1, 1};
  for (unsigned int axis = 0; axis < axes; ++axis) {
    const std::vector<double> direction = io.GetDirection(axis);
    grid.size[axis] = static_cast<std::int64_t>(io.GetDimensions(axis));
    grid.spacing_mm[axis] = io.GetSpacing(axis);
    grid.origin_mm[axis] = io.GetOrigin(axis);
    for (unsigned int row = 0; row < axes; ++row)
      grid.direction[row][axis] = direction.at(row);
  }
  return grid;
}

Grid checked_grid(const itk::ImageIOBase &io, const fs::path &path)
{
  check_scalar(io, path);
  check_dimensions(io, path);
  const Grid grid = grid_of(io);
  check_geometry(grid, path);
  return grid;
}

void check_axes(const Grid &grid, const fs::path &path)
{
  if (std::any_of(grid.size.begin(), grid.size.end(), [](std::int64_t size) { return size < 2; }))
    fail(path,
         "a volume of " + std::to_string(grid.size[0]) + " x " + std::to_string(grid.size[1]) + " x " +
             std::to_string(grid.size[2]) + " samples",
         "2 or more on each axis");
}

void check_memory(const Grid &grid, const fs::path &path, const ReadOptions &options)
{
  std::int64_t bytes = sizeof(float);
  bool overflow = false;
  for (const std::int64_t size : grid.size)
    overflow = __builtin_mul_overflow(bytes, size, &bytes) || overflow;
  if (overflow)
    fail(path,
         "a volume of " + std::to_string(grid.size[0]) + " x " + std::to_string(grid.size[1]) + " x " +
             std::to_string(grid.size[2]) + " samples",
         "fewer than 2^61 samples");
  if (options.check_grid)
    options.check_grid(grid);
}

std::string pixel_type_name(const itk::ImageIOBase &io)
{
  const Component type = io.GetComponentType();
  const std::string bits = std::to_string(8 * io.GetComponentSize());
  if (type == Component::FLOAT || type == Component::DOUBLE)
    return "float" + bits;
  const bool is_signed = type == Component::CHAR || type == Component::SHORT || type == Component::INT ||
                         type == Component::LONG || type == Component::LONGLONG;
  return (is_signed ? "int" : "uint") + bits;
}

void read_samples(itk::ImageIOBase &io, const fs::path &path, float *samples, std::size_t count)
{
  io.SetIORegion(whole_region(io));
  try {
    if (io.GetComponentType() == Component::FLOAT) {
      io.Read(samples);
      return;
    }
    const std::unique_ptr<std::byte[]> bytes(new std::byte[count * io.GetComponentSize()]);
    io.Read(bytes.get());
    convert(io.GetComponentType(), bytes.get(), samples, count);
  } catch (const itk::ExceptionObject &error) {
    throw InputError(path.string() + ": the samples cannot be read: " + one_line(error));
  }
}

} // namespace volsurf
