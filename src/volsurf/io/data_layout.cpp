#include "volsurf/io/data_layout.h"

#include "volsurf/core/error.h"
#include "volsurf/io/inflate.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace volsurf {

namespace {

constexpr char kAllowedFormats[] =
    "NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd), NIfTI (.nii, .nii.gz) or a folder with a DICOM series";
constexpr std::size_t kLongestHeaderLine = 1 << 20;
constexpr std::uint64_t kMostDataFiles = 1 << 16;

[[noreturn]] void fail(const fs::path &path, const std::string &found, const std::string &allowed)
{
  throw InputError(path.string() + ": found " + found + "; allowed: " + allowed);
}

std::string trimmed(const std::string &text)
{
  const auto first = text.find_first_not_of(" \t\r\n");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::string lower_case(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool ends_with(const std::string &text, const std::string &end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// The text lines of a header, counted, up to the binary data.
class HeaderLines {
public:
  explicit HeaderLines(const fs::path &path) : path_(path), stream_(path, std::ios::binary) {}

  bool next(std::string &line)
  {
    if (!std::getline(stream_, line))
      return false;
    if (line.size() > kLongestHeaderLine)
      fail(path_, "a header that does not end", "a text header");
    offset_ += line.size() + 1;
    line = trimmed(line);
    return true;
  }

  std::uint64_t offset() const { return offset_; } ///< of the byte after the last line

private:
  fs::path path_;
  std::ifstream stream_;
  std::uint64_t offset_ = 0;
};

using Fields = std::map<std::string, std::string>;

std::string field(const Fields &fields, const std::string &name, const std::string &missing = "")
{
  const auto found = fields.find(name);
  return found == fields.end() ? missing : found->second;
}

std::int64_t integer_field(const fs::path &path, const Fields &fields, const std::string &name)
{
  const std::string text = field(fields, name, "0");
  try {
    return std::stoll(text);
  } catch (const std::exception &) {
    fail(path, "\"" + name + ": " + text + "\" in the header", "an integer");
  }
}

/// The files of a printf pattern, "slice%03d.raw 1 10 1"; both formats write it so. Only one integer conversion is
/// allowed, since anything else would read arguments that are not there.
std::vector<std::string> numbered_files(const fs::path &path, const std::string &text)
{
  std::istringstream words(text);
  std::string pattern;
  std::int64_t first = 0;
  std::int64_t last = 0;
  std::int64_t step = 1;
  words >> pattern >> first >> last >> step;
  const auto percent = pattern.find('%');
  const auto letter = pattern.find_first_not_of("0123456789", percent + 1);
  const bool well_formed = letter != std::string::npos && pattern[letter] == 'd' &&
                           pattern.find('%', letter) == std::string::npos && letter - percent < 5;
  if (!well_formed || step == 0 || (last - first) / step < 0 || (last - first) / step > std::int64_t{kMostDataFiles})
    fail(path, "the data file pattern \"" + text + "\"", "NAME%03d.raw FIRST LAST STEP");
  std::vector<std::string> names;
  for (std::int64_t i = first; step > 0 ? i <= last : i >= last; i += step) {
    std::array<char, 32> number{};
    const std::string conversion = pattern.substr(percent, letter - percent) + "ld";
    std::snprintf(number.data(), number.size(), conversion.c_str(), static_cast<long>(i));
    names.push_back(pattern.substr(0, percent) + number.data() + pattern.substr(letter + 1));
  }
  return names;
}

/// `text` names one file, a pattern of files, or (LIST) the files in the header's remaining lines.
void set_data_files(const fs::path &path, const std::string &text, HeaderLines &lines, DataLayout &layout)
{
  std::vector<std::string> names;
  if (text == "LIST" || text.rfind("LIST ", 0) == 0) {
    std::string line;
    while (lines.next(line))
      if (!line.empty())
        names.push_back(line);
  } else if (text.find('%') != std::string::npos) {
    names = numbered_files(path, text);
  } else {
    names.push_back(text);
  }
  if (names.empty())
    fail(path, "a header that names no data file", "one or more");
  layout.detached = true;
  for (const std::string &name : names) {
    const fs::path file = path.parent_path() / name;
    std::error_code error;
    if (!fs::is_regular_file(file, error))
      fail(path, "a header whose data file " + name + " does not exist", "a complete volume");
    layout.data_files.push_back(file);
  }
}

/// A skip of -1 means that the samples are the end of the file.
std::uint64_t offset_for_skip(const fs::path &path, std::int64_t skip, std::uint64_t header_end)
{
  if (skip < -1)
    fail(path, "a skip of " + std::to_string(skip) + " bytes", "-1 or more");
  return skip < 0 ? 0 : header_end + static_cast<std::uint64_t>(skip);
}

std::uint64_t after_lines(const fs::path &file, std::uint64_t offset, std::int64_t count)
{
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(offset));
  std::string line;
  for (std::int64_t i = 0; i < count && std::getline(stream, line); ++i)
    offset += line.size() + 1;
  return offset;
}

DataLayout nrrd_layout(const fs::path &path)
{
  HeaderLines lines(path);
  Fields fields;
  std::string line;
  DataLayout layout;
  while (lines.next(line) && !line.empty()) {
    const auto colon = line.find(": ");
    if (line[0] == '#' || colon == std::string::npos)
      continue;
    std::string name = lower_case(line.substr(0, colon));
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    fields[name] = trimmed(line.substr(colon + 2));
    if (name == "datafile")
      set_data_files(path, fields[name], lines, layout);
  }
  if (!layout.detached)
    layout.data_files = {path};
  const std::string encoding = lower_case(field(fields, "encoding"));
  const std::uint64_t start =
      after_lines(layout.data_files[0], layout.detached ? 0 : lines.offset(), integer_field(path, fields, "lineskip"));
  const std::int64_t skip = integer_field(path, fields, "byteskip");
  const bool gzip = encoding == "gzip" || encoding == "gz";
  layout.packing = encoding == "raw" ? DataLayout::Packing::raw
                   : gzip            ? DataLayout::Packing::deflate
                                     : DataLayout::Packing::other;
  layout.packed_offset = start;
  layout.offset = offset_for_skip(path, skip, gzip ? 0 : start);
  return layout;
}

DataLayout meta_layout(const fs::path &path)
{
  HeaderLines lines(path);
  Fields fields;
  std::string line;
  DataLayout layout;
  while (fields.count("elementdatafile") == 0 && lines.next(line)) {
    const auto equals = line.find('=');
    if (equals != std::string::npos)
      fields[lower_case(trimmed(line.substr(0, equals)))] = trimmed(line.substr(equals + 1));
  }
  // MetaIO loops without end on a negative number and keeps arrays of 10.
  const std::int64_t axes = integer_field(path, fields, "ndims");
  if (axes < 1 || axes > 10)
    fail(path, "NDims = " + std::to_string(axes) + " in the header", "3");
  const std::string data = field(fields, "elementdatafile");
  if (data.empty())
    fail(path, "a MetaImage header without ElementDataFile", "a complete header");
  const bool local = lower_case(data) == "local";
  if (local)
    layout.data_files = {path};
  else
    set_data_files(path, data, lines, layout);
  const bool binary = lower_case(field(fields, "binarydata", "true")) == "true";
  const bool packed = lower_case(field(fields, "compresseddata")) == "true";
  layout.packing = !binary  ? DataLayout::Packing::other
                   : packed ? DataLayout::Packing::deflate
                            : DataLayout::Packing::raw;
  const std::uint64_t start = local ? lines.offset() : 0;
  const std::uint64_t offset = offset_for_skip(path, integer_field(path, fields, "headersize"), start);
  layout.packed_offset = packed ? offset : 0;
  layout.offset = packed ? 0 : offset;
  return layout;
}

template <typename Value> Value value_at(const std::string &bytes, std::size_t offset, bool swapped)
{
  std::array<char, sizeof(Value)> raw{};
  std::memcpy(raw.data(), bytes.data() + offset, raw.size());
  if (swapped)
    std::reverse(raw.begin(), raw.end());
  Value value{};
  std::memcpy(&value, raw.data(), raw.size());
  return value;
}

constexpr std::size_t kNifti1HeaderBytes = 348;

/// The standard's data types. ITK's NIfTI library prints where it meets another.
bool is_nifti_type(std::int16_t type)
{
  static const std::set<std::int16_t> types = {2,   4,   8,    16,   32,   64,   128,  256,
                                               512, 768, 1024, 1280, 1536, 1792, 2048, 2304};
  return types.count(type) > 0;
}

DataLayout nifti_layout(const fs::path &path)
{
  const std::string header = inflated_start(path, kNifti1HeaderBytes);
  const bool swapped = value_at<std::int32_t>(header, 0, false) != std::int32_t{kNifti1HeaderBytes};
  const auto axes = value_at<std::int16_t>(header, 40, swapped);
  const auto bits_per_sample = value_at<std::int16_t>(header, 72, swapped);
  const auto offset = value_at<float>(header, 108, swapped);
  const auto type = value_at<std::int16_t>(header, 70, swapped);
  if (axes < 1 || axes > 7 || !is_nifti_type(type) || bits_per_sample < 1 || !(offset >= 0) || offset > 1e9F)
    fail(path, "a damaged NIfTI header", "an intact file");
  std::uint64_t bytes = static_cast<std::uint64_t>(bits_per_sample) / 8;
  for (std::size_t axis = 1; axis <= static_cast<std::size_t>(axes); ++axis) {
    const auto size = value_at<std::int16_t>(header, 40 + 2 * axis, swapped);
    if (size < 0 || __builtin_mul_overflow(bytes, static_cast<std::uint64_t>(std::max<int>(size, 1)), &bytes))
      fail(path, "impossible sizes in the NIfTI header", "an intact file");
  }
  DataLayout layout;
  layout.data_files = {path};
  layout.packing =
      ends_with(lower_case(path.string()), ".gz") ? DataLayout::Packing::deflate : DataLayout::Packing::raw;
  layout.offset = static_cast<std::uint64_t>(offset);
  layout.data_bytes = bytes;
  return layout;
}

bool has_magic(const std::string &start, VolumeFormat format)
{
  if (format == VolumeFormat::nrrd)
    return start.rfind("NRRD", 0) == 0;
  if (format == VolumeFormat::meta)
    return start.find("NDims") != std::string::npos || start.find("ObjectType") != std::string::npos;
  return start.size() >= kNifti1HeaderBytes && start.compare(344, 3, "n+1") == 0;
}

} // namespace

VolumeFormat volume_format_of(const fs::path &path)
{
  const std::string name = lower_case(path.filename().string());
  std::optional<VolumeFormat> format;
  if (ends_with(name, ".nrrd") || ends_with(name, ".nhdr"))
    format = VolumeFormat::nrrd;
  else if (ends_with(name, ".mha") || ends_with(name, ".mhd"))
    format = VolumeFormat::meta;
  else if (ends_with(name, ".nii") || ends_with(name, ".nii.gz"))
    format = VolumeFormat::nifti;
  if (!format)
    fail(path, "a file of unknown kind", kAllowedFormats);
  const std::size_t start_bytes = 8192;
  if (!has_magic(inflated_start(path, start_bytes), *format))
    fail(path, "a file that does not begin like " + format_name(*format), kAllowedFormats);
  return *format;
}

std::string format_name(VolumeFormat format)
{
  return format == VolumeFormat::nrrd ? "NRRD" : format == VolumeFormat::meta ? "MetaImage" : "NIfTI";
}

DataLayout read_data_layout(const fs::path &path, VolumeFormat format)
{
  switch (format) {
  case VolumeFormat::nrrd:
    return nrrd_layout(path);
  case VolumeFormat::meta:
    return meta_layout(path);
  case VolumeFormat::nifti:
    break;
  }
  return nifti_layout(path);
}

void check_data_size(const fs::path &path, const DataLayout &layout, std::uint64_t data_bytes)
{
  if (layout.packing == DataLayout::Packing::other)
    return;
  const std::uint64_t share = data_bytes / layout.data_files.size();
  for (const fs::path &file : layout.data_files) {
    const std::uint64_t found =
        layout.packing == DataLayout::Packing::raw ? fs::file_size(file) : inflated_size(file, layout.packed_offset);
    const std::uint64_t samples = found > layout.offset ? found - layout.offset : 0;
    if (samples < share)
      fail(path,
           std::to_string(samples) + " bytes of samples" + (layout.detached ? " in " + file.filename().string() : "") +
               " where the header announces " + std::to_string(share),
           "a complete file");
  }
}

} // namespace volsurf
