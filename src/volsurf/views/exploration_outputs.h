// The files of an exploration.
#pragma once

#include "volsurf/io/output_file.h"
#include "volsurf/pipeline/explore.h"

#include <optional>

namespace volsurf::views {

struct ExplorationFiles {
  std::optional<std::filesystem::path> csv;
  std::optional<std::filesystem::path> png;
  std::optional<std::filesystem::path> html;

  bool any() const { return csv || png || html; }
  std::vector<std::filesystem::path> all() const;
};

/// They are written under other names, so that they can appear together, at the end, or not at all. Throws OutputError.
class ExplorationOutputs {
public:
  /// Fails at once where a file cannot be made. Throws UsageError where a file is named twice or is the input.
  ExplorationOutputs(const ExplorationFiles &files, const std::filesystem::path &input);

  void write(const Exploration &exploration);

  /// Makes the files appear.
  void commit();

private:
  std::optional<PendingOutput> csv_;
  std::optional<PendingOutput> png_;
  std::optional<PendingOutput> html_;
};

} // namespace volsurf::views
