#include "volsurf/io/dicom_series.h"

#include "volsurf/core/error.h"
#include "volsurf/core/vec3.h"
#include "volsurf/io/dicom_file.h"
#include "volsurf/io/itk_image_io.h"
#include "volsurf/io/sha256.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <itkGDCMImageIO.h>
#include <itkMetaDataObject.h>
#include <map>
#include <utility>

namespace fs = std::filesystem;

namespace volsurf {

namespace {

[[noreturn]] void fail(const fs::path &path, const std::string &found, const std::string &allowed)
{
  throw InputError(path.string() + ": found " + found + "; allowed: " + allowed);
}

struct Slice {
  fs::path file;
  Grid grid;
};

struct Series {
  std::string uid;
  std::string description;
  std::vector<Slice> slices; ///< in order of position once sorted
};

/// A text element on one line, without its padding.
std::string text_of(const itk::ImageIOBase &io, const char *tag)
{
  std::string text;
  itk::ExposeMetaData<std::string>(io.GetMetaDataDictionary(), tag, text);
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  while (!text.empty() && text.back() == ' ')
    text.pop_back();
  return text;
}

std::vector<fs::path> dicom_files(const fs::path &folder)
{
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry &entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file() && begins_like_dicom(entry.path()))
      files.push_back(entry.path());
  if (error)
    throw InputError(folder.string() + ": the folder cannot be read: " + error.message());
  std::sort(files.begin(), files.end());
  return files;
}

/// Not by GDCMSeriesFileNames, which hands every file of the folder to GDCM, and GDCM aborts on some that are damaged.
std::vector<Series> find_series(const fs::path &folder)
{
  std::map<std::string, Series> by_uid;
  for (const fs::path &file : dicom_files(folder)) {
    if (!holds_complete_image(file))
      continue;
    const auto io = itk::GDCMImageIO::New();
    io->SetFileName(file.string());
    try {
      io->ReadImageInformation();
    } catch (const itk::ExceptionObject &) {
      continue; // pixels of a kind that GDCM does not know
    }
    const std::string uid = text_of(*io, "0020|000e");
    Series &series = by_uid[uid];
    series.uid = uid;
    series.description = text_of(*io, "0008|103e");
    series.slices.push_back({file, grid_of(*io)});
  }
  std::vector<Series> all;
  for (auto &[uid, series] : by_uid)
    all.push_back(std::move(series));
  return all;
}

std::string list(const std::vector<Series> &all)
{
  std::string text;
  for (const Series &series : all)
    text += (text.empty() ? "" : ", ") + series.uid + " (" +
            (series.description.empty() ? "no description" : "\"" + series.description + "\"") + ", " +
            std::to_string(series.slices.size()) + (series.slices.size() == 1 ? " file)" : " files)");
  return text;
}

Series choose_series(const fs::path &folder, const std::string &uid)
{
  const std::vector<Series> all = find_series(folder);
  if (all.empty())
    fail(folder, "a folder without DICOM images", "a folder with a DICOM series");
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

/// Sets the third axis from the positions of the slices. A missing slice would bend the whole volume, so uneven steps
/// are refused.
void stack(Grid &grid, const std::vector<Vec3> &positions, const fs::path &path)
{
  const std::size_t steps = positions.size() - 1;
  const Vec3 way = minus(positions.back(), positions.front());
  const double spacing_mm = length(way) / static_cast<double>(steps);
  constexpr double kTolerance = 0.1; // of the spacing; positions in DICOM files are decimal and often rounded
  for (std::size_t i = 1; i < positions.size(); ++i)
    if (!(length(minus(positions[i], positions[i - 1])) > kTolerance * spacing_mm))
      fail(path, "two slices at one position", "one slice per position (one time point, one echo)");
  for (std::size_t i = 1; i < positions.size(); ++i) {
    const double step_mm = length(minus(positions[i], positions[i - 1]));
    if (std::abs(step_mm - spacing_mm) > kTolerance * spacing_mm)
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

void sort_by_position(std::vector<Slice> &slices)
{
  const Mat3 d = slices.front().grid.direction;
  const Vec3 normal{d[1][0] * d[2][1] - d[2][0] * d[1][1], d[2][0] * d[0][1] - d[0][0] * d[2][1],
                    d[0][0] * d[1][1] - d[1][0] * d[0][1]};
  const auto height = [&normal](const Slice &slice) {
    const Vec3 &at = slice.grid.origin_mm;
    return at[0] * normal[0] + at[1] * normal[1] + at[2] * normal[2];
  };
  std::stable_sort(slices.begin(), slices.end(),
                   [&height](const Slice &a, const Slice &b) { return height(a) < height(b); });
}

bool same_plane(const Grid &a, const Grid &b)
{
  constexpr double kTolerance = 1e-3;
  bool same = a.size == b.size;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    same = same && std::abs(a.spacing_mm[axis] - b.spacing_mm[axis]) < kTolerance;
    for (std::size_t row = 0; row < 3; ++row)
      same = same && std::abs(a.direction[row][axis] - b.direction[row][axis]) < kTolerance;
  }
  return same;
}

/// The grid of the whole series, whose slices it puts in order.
Grid series_grid(std::vector<Slice> &slices)
{
  sort_by_position(slices);
  Grid grid = slices.front().grid;
  if (slices.size() == 1)
    return grid;
  if (grid.size[2] != 1)
    fail(slices.front().file, "one of several files that hold several slices each", "one slice per file, or one file");
  std::vector<Vec3> positions;
  for (const Slice &slice : slices) {
    if (!same_plane(slice.grid, grid))
      fail(slice.file, "a slice of another size, spacing or orientation than the series' first", "parallel slices");
    positions.push_back(slice.grid.origin_mm);
  }
  stack(grid, positions, slices.front().file.parent_path());
  return grid;
}

} // namespace

InputVolume read_dicom_folder(const fs::path &folder, const ReadOptions &options)
{
  std::vector<Slice> slices = choose_series(folder, options.series_uid).slices;
  InputVolume input;
  Volume &volume = input.volume;
  std::vector<fs::path> files;
  volume.grid = series_grid(slices);
  check_axes(volume.grid, folder);
  check_memory(volume.grid, folder, options);
  volume.samples.resize(static_cast<std::size_t>(volume.grid.sample_count()));
  const std::size_t samples_per_file = volume.samples.size() / slices.size();
  float *next = volume.samples.data();
  for (const Slice &slice : slices) {
    const auto io = itk::GDCMImageIO::New();
    read_information(*io, slice.file, "DICOM");
    checked_grid(*io, slice.file);
    read_samples(*io, slice.file, next, samples_per_file);
    input.pixel_type = pixel_type_name(*io);
    next += samples_per_file;
    files.push_back(slice.file);
  }
  const FileDigest digest = sha256_of_files(files);
  input.source = {folder.string(), digest.bytes, digest.sha256};
  return input;
}

} // namespace volsurf
