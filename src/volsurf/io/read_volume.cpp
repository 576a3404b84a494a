#include "volsurf/io/read_volume.h"

#include "volsurf/core/error.h"
#include "volsurf/io/data_layout.h"
#include "volsurf/io/dicom_series.h"
#include "volsurf/io/itk_image_io.h"
#include "volsurf/io/sha256.h"

#include <cmath>
#include <fstream>
#include <itkMetaDataObject.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <new>
#include <sstream>

namespace fs = std::filesystem;

namespace volsurf {

namespace {

[[noreturn]] void fail(const fs::path &path, const std::string &found, const std::string &allowed)
{
  throw InputError(path.string() + ": found " + found + "; allowed: " + allowed);
}

itk::ImageIOBase::Pointer image_io(VolumeFormat format)
{
  switch (format) {
  case VolumeFormat::nrrd:
    return itk::NrrdImageIO::New().GetPointer();
  case VolumeFormat::meta:
    return itk::MetaImageIO::New().GetPointer();
  case VolumeFormat::nifti:
    break;
  }
  return itk::NiftiImageIO::New().GetPointer();
}

/// ITK takes a NIfTI file's orientation only where its sform is a rotation with scales, or its qform stands in for it.
void explain_nifti_orientation(const fs::path &path, const InputError &error)
{
  if (std::string(error.what()).find("orthonormal") != std::string::npos)
    fail(path, "a NIfTI sform that shears (its axes are not orthogonal to about 0.001) and no qform to use instead",
         "orthogonal axes; resample the volume, or repair its sform");
}

std::vector<double> numbers(const itk::MetaDataDictionary &dictionary, const std::string &key)
{
  std::string text;
  itk::ExposeMetaData<std::string>(dictionary, key, text);
  std::istringstream words(text);
  std::vector<double> values;
  for (double value = 0; words >> value;)
    values.push_back(value);
  return values;
}

/// Where a NIfTI file's sform and qform disagree, ITK may silently take the qform.
void warn_of_dropped_sform(const itk::ImageIOBase &io, const Grid &grid, std::vector<std::string> &warnings)
{
  const itk::MetaDataDictionary &dictionary = io.GetMetaDataDictionary();
  const std::vector<double> code = numbers(dictionary, "sform_code");
  if (code.empty() || code[0] <= 0)
    return;
  const char *const keys[] = {"srow_x", "srow_y", "srow_z"};
  const Vec3 last{double(grid.size[0] - 1), double(grid.size[1] - 1), double(grid.size[2] - 1)};
  const Vec3 lps = index_to_world(grid, last);
  const Vec3 ras{-lps[0], -lps[1], lps[2]};
  double worst_mm = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> row = numbers(dictionary, keys[axis]);
    if (row.size() != 4)
      return;
    const double sform = row[0] * last[0] + row[1] * last[1] + row[2] * last[2] + row[3];
    worst_mm = std::max(worst_mm, std::abs(sform - ras[axis]));
  }
  if (worst_mm > 0.5 * smallest_spacing_mm(grid))
    warnings.push_back("the NIfTI sform and the qform that is used differ by " + std::to_string(worst_mm) +
                       " mm at the volume's last corner");
}

void warn_of_shear(const Grid &grid, std::vector<std::string> &warnings)
{
  double worst = 0;
  for (int a = 0; a < 3; ++a)
    for (int b = a + 1; b < 3; ++b) {
      double product = 0;
      for (int row = 0; row < 3; ++row)
        product += grid.direction[row][a] * grid.direction[row][b];
      worst = std::max(worst, std::abs(product));
    }
  constexpr double kTolerance = 1e-3; // a drift of half a voxel across 512
  constexpr double kDegrees = 57.29577951308232;
  if (worst > kTolerance)
    warnings.push_back("the volume's axes are not orthogonal (off by " +
                       std::to_string(std::asin(std::min(worst, 1.0)) * kDegrees) +
                       " kDegrees), as of a tilted gantry");
}

void check_finite(const Volume &volume, const fs::path &path)
{
  std::int64_t count = 0;
  std::int64_t first = -1;
  for (std::size_t i = 0; i < volume.samples.size(); ++i)
    if (!std::isfinite(volume.samples[i])) {
      first = count++ == 0 ? static_cast<std::int64_t>(i) : first;
    }
  if (count == 0)
    return;
  const Index3 &size = volume.grid.size;
  fail(path,
       std::to_string(count) + (count == 1 ? " sample that is" : " samples that are") +
           " not finite, the first at index (" + std::to_string(first % size[0]) + ", " +
           std::to_string(first / size[0] % size[1]) + ", " + std::to_string(first / (size[0] * size[1])) + ")",
       "finite samples");
}

std::uint64_t data_bytes(const itk::ImageIOBase &io, const fs::path &path)
{
  std::uint64_t bytes = io.GetComponentSize();
  for (unsigned int axis = 0; axis < io.GetNumberOfDimensions(); ++axis)
    if (__builtin_mul_overflow(bytes, std::uint64_t{io.GetDimensions(axis)}, &bytes))
      fail(path, "sizes whose product overflows", "a volume that fits into memory");
  return bytes;
}

InputVolume read_file(const fs::path &path, const ReadOptions &options)
{
  const VolumeFormat format = volume_format_of(path);
  const DataLayout layout = read_data_layout(path, format);
  const itk::ImageIOBase::Pointer io = image_io(format);
  InputVolume input;
  try {
    read_information(*io, path, format_name(format));
  } catch (const InputError &error) {
    explain_nifti_orientation(path, error);
    throw;
  }
  Volume &volume = input.volume;
  volume.grid = checked_grid(*io, path);
  check_axes(volume.grid, path);
  check_memory(volume.grid, path, options);
  check_data_size(path, layout, layout.data_bytes.value_or(data_bytes(*io, path)));
  volume.samples.resize(static_cast<std::size_t>(volume.grid.sample_count()));
  read_samples(*io, path, volume.samples.data(), volume.samples.size());
  input.pixel_type = pixel_type_name(*io);
  if (format == VolumeFormat::nifti)
    warn_of_dropped_sform(*io, volume.grid, input.warnings);
  std::vector<fs::path> files = layout.data_files;
  if (layout.detached)
    files.insert(files.begin(), path);
  const FileDigest digest = sha256_of_files(files);
  input.source = {path.string(), digest.bytes, digest.sha256};
  return input;
}

void check_readable(const fs::path &path)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
    throw InputError(path.string() + ": the file does not exist");
  if (fs::is_directory(status))
    return;
  if (!fs::is_regular_file(status))
    fail(path, "a device or pipe", "a file or a DICOM folder");
  if (!std::ifstream(path))
    throw InputError(path.string() + ": the file cannot be opened for reading");
}

} // namespace

InputVolume read_volume(const fs::path &path, const ReadOptions &options)
{
  check_readable(path);
  const QuietItk quiet;
  try {
    InputVolume input = fs::is_directory(path) ? read_dicom_folder(path, options) : read_file(path, options);
    check_finite(input.volume, path);
    warn_of_shear(input.volume.grid, input.warnings);
    return input;
  } catch (const std::bad_alloc &) {
    fail(path, "a volume that does not fit into memory", "a smaller one");
  } catch (const std::length_error &) {
    fail(path, "a volume that does not fit into memory", "a smaller one");
  }
}

} // namespace volsurf
