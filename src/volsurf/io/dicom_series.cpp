#include "volsurf/io/dicom_series.h"

#include "volsurf/core/error.h"
#include "volsurf/io/itk_image_io.h"
#include "volsurf/io/sha256.h"

#include <algorithm>
#include <cmath>
#include <itkGDCMImageIO.h>
#include <itkGDCMSeriesFileNames.h>
#include <itkMetaDataObject.h>

namespace fs = std::filesystem;

namespace volsurf {

namespace {

[[noreturn]] void fail(const fs::path &path, const std::string &found, const std::string &allowed)
{
  throw InputError(path.string() + ": found " + found + "; allowed: " + allowed);
}

struct Series {
  std::string uid;
  std::vector<std::string> files; ///< in order of position
};

std::vector<Series> find_series(const fs::path &folder)
{
  const auto names = itk::GDCMSeriesFileNames::New();
  names->SetUseSeriesDetails(true); // tells apart localizers and orientations that share a UID
  names->SetRecursive(false);
  std::vector<Series> all;
  try {
    names->SetDirectory(folder.string());
    for (const std::string &uid : names->GetSeriesUIDs())
      all.push_back({uid, names->GetFileNames(uid)});
  } catch (const itk::ExceptionObject &error) {
    throw InputError(folder.string() + ": the folder cannot be read as DICOM: " + one_line(error));
  }
  return all;
}

std::string description(const Series &series)
{
  const auto io = itk::GDCMImageIO::New();
  std::string text;
  try {
    io->SetFileName(series.files.front());
    io->ReadImageInformation();
    itk::ExposeMetaData<std::string>(io->GetMetaDataDictionary(), "0008|103e", text);
  } catch (const itk::ExceptionObject &) {
    return "unreadable";
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0'))
    text.pop_back();
  return text.empty() ? "no description" : "\"" + text + "\"";
}

std::string list(const std::vector<Series> &all)
{
  std::string text;
  for (const Series &series : all)
    text += (text.empty() ? "" : ", ") + series.uid + " (" + description(series) + ", " +
            std::to_string(series.files.size()) + (series.files.size() == 1 ? " file)" : " files)");
  return text;
}

Series choose_series(const fs::path &folder, const std::string &uid)
{
  const std::vector<Series> all = find_series(folder);
  if (all.empty())
    fail(folder, "a folder without DICOM files", "a folder with a DICOM series");
  std::vector<Series> matching;
  for (const Series &series : all) {
    if (series.uid == uid)
      return series;
    if (series.uid.rfind(uid, 0) == 0)
      matching.push_back(series);
  }
  if (matching.size() == 1)
    return matching.front();
  if (matching.empty())
    fail(folder, "no series " + uid, "--series with one of: " + list(all));
  fail(folder, std::to_string(matching.size()) + " DICOM series", "one; choose by --series UID: " + list(matching));
}

Vec3 minus(const Vec3 &a, const Vec3 &b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double length(const Vec3 &v)
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// Sets the third axis from the positions of the slices. A missing slice would bend the whole volume, so uneven steps
/// are refused.
void stack(Grid &grid, const std::vector<Vec3> &positions, const fs::path &path)
{
  const std::size_t steps = positions.size() - 1;
  const Vec3 way = minus(positions.back(), positions.front());
  const double spacing_mm = length(way) / static_cast<double>(steps);
  constexpr double tolerance = 0.1; // of the spacing; positions in DICOM files are decimal and often rounded
  if (!(spacing_mm > 0))
    fail(path, "slices that share one position", "one slice per position (one time point)");
  for (std::size_t i = 1; i < positions.size(); ++i) {
    const double step_mm = length(minus(positions[i], positions[i - 1]));
    if (std::abs(step_mm - spacing_mm) > tolerance * spacing_mm)
      fail(path,
           "a step of " + std::to_string(step_mm) + " mm between slices " + std::to_string(i - 1) + " and " +
               std::to_string(i) + " where the mean is " + std::to_string(spacing_mm) + " mm",
           "evenly spaced slices, none missing");
  }
  grid.size[2] = static_cast<std::int64_t>(positions.size());
  grid.spacing_mm[2] = spacing_mm;
  for (std::size_t row = 0; row < 3; ++row)
    grid.direction[row][2] = way[row] / length(way);
}

/// The grid of the whole series, from the headers of its files.
Grid series_grid(const std::vector<std::string> &files)
{
  std::vector<Vec3> positions;
  Grid first;
  for (const std::string &file : files) {
    const auto io = itk::GDCMImageIO::New();
    read_information(*io, file, "DICOM");
    const Grid slice = checked_grid(*io, file);
    if (positions.empty())
      first = slice;
    if (slice.size != first.size)
      fail(file, "a slice of another size than the first one's", "slices of one size");
    positions.push_back(slice.origin_mm);
  }
  if (files.size() > 1 && first.size[2] != 1)
    fail(files.front(), "several files that hold several slices each", "one slice per file, or a single file");
  if (files.size() > 1)
    stack(first, positions, files.front());
  return first;
}

} // namespace

InputVolume read_dicom_folder(const fs::path &folder, const ReadOptions &options)
{
  const std::vector<std::string> files = choose_series(folder, options.series_uid).files;
  InputVolume input;
  Volume &volume = input.volume;
  volume.grid = series_grid(files);
  check_axes(volume.grid, folder);
  check_memory(volume.grid, folder, options);
  volume.samples.resize(static_cast<std::size_t>(volume.grid.sample_count()));
  const std::size_t samples_per_file = volume.samples.size() / files.size();
  float *next = volume.samples.data();
  for (const std::string &file : files) {
    const auto io = itk::GDCMImageIO::New();
    read_information(*io, file, "DICOM");
    read_samples(*io, file, next, samples_per_file);
    input.pixel_type = pixel_type_name(*io);
    next += samples_per_file;
  }
  const FileDigest digest = sha256_of_files({files.begin(), files.end()});
  input.source = {folder.string(), digest.bytes, digest.sha256};
  return input;
}

} // namespace volsurf
