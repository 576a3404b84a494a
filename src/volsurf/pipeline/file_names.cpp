#include "volsurf/pipeline/file_names.h"

#include "volsurf/core/error.h"
#include "volsurf/io/write_mesh.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace fs = std::filesystem;

namespace volsurf {

namespace {

/// The one name of a file, whether it exists or not. A name that cannot be followed stays as it is, for the reader or
/// the writer to refuse.
fs::path place_of(const fs::path &file)
{
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(file, error), error);
  return error ? file : place;
}

bool ends_with(const std::string &text, const std::string &end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

} // namespace

bool is_vdb(const fs::path &output)
{
  return output_kind_of(output) == OutputKind::vdb;
}

bool is_segmentation(const fs::path &labels)
{
  return ends_with(labels.filename().string(), ".seg.nrrd");
}

std::vector<fs::path> surface_outputs(const Settings &settings)
{
  std::vector<fs::path> outputs;
  std::remove_copy_if(settings.outputs.begin(), settings.outputs.end(), std::back_inserter(outputs), is_vdb);
  return outputs;
}

fs::path part_file(const fs::path &output, Split split, std::uint32_t number, std::uint32_t highest)
{
  if (split == Split::none)
    return output;
  std::string digits = std::to_string(number);
  digits.insert(0, std::to_string(highest).size() - digits.size(), '0');
  fs::path name = output.stem();
  name += (split == Split::regions ? "_region_" : "_component_") + digits;
  name += output.extension();
  return output.parent_path() / name;
}

void require_distinct_files(const Settings &settings, std::vector<fs::path> files)
{
  for (const auto &file : {settings.labels, settings.report, settings.hierarchy})
    if (file)
      files.push_back(*file);
  files.push_back(settings.input);
  require_distinct_files(std::move(files));
}

void require_distinct_files(std::vector<fs::path> files)
{
  for (fs::path &file : files)
    file = place_of(file);
  std::sort(files.begin(), files.end());
  const auto twice = std::adjacent_find(files.begin(), files.end());
  if (twice != files.end())
    throw UsageError(twice->string() + ": it is named twice; inputs and outputs must be different files");
}

} // namespace volsurf
