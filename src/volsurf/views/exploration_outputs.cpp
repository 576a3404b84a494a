#include "volsurf/views/exploration_outputs.h"

#include "volsurf/pipeline/file_names.h"
#include "volsurf/views/charts.h"
#include "volsurf/views/page.h"
#include "volsurf/views/text.h"

namespace volsurf::views {

namespace {

template <typename ToBytes>
void write_output(const std::optional<PendingOutput> &output, const Exploration &exploration, ToBytes to_bytes)
{
  if (output)
    output->write([&](const std::filesystem::path &path) { write_bytes(to_bytes(exploration), path); });
}

} // namespace

std::vector<std::filesystem::path> ExplorationFiles::all() const
{
  std::vector<std::filesystem::path> files;
  for (const auto &file : {csv, png, html})
    if (file)
      files.push_back(*file);
  return files;
}

ExplorationOutputs::ExplorationOutputs(const ExplorationFiles &files, const std::filesystem::path &input)
{
  std::vector<std::filesystem::path> all = files.all();
  all.push_back(input);
  require_distinct_files(all);
  if (files.csv)
    csv_.emplace(*files.csv);
  if (files.png)
    png_.emplace(*files.png);
  if (files.html)
    html_.emplace(*files.html);
}

void ExplorationOutputs::write(const Exploration &exploration)
{
  write_output(csv_, exploration, [](const Exploration &e) { return to_csv(e.curve); });
  write_output(png_, exploration, to_png);
  write_output(html_, exploration, to_html);
}

void ExplorationOutputs::commit()
{
  for (auto *output : {&csv_, &png_, &html_})
    if (*output)
      (*output)->commit();
}

} // namespace volsurf::views
