// volsurf-compare from files to files, without its command line.
#pragma once

#include "volsurf/interop/frame.h"
#include "volsurf/io/read_volume.h"
#include "volsurf/pipeline/comparison.h"
#include "volsurf/pipeline/metrics.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace volsurf {

struct CompareSettings {
  std::filesystem::path a;
  std::filesystem::path b;   ///< the reference
  std::vector<float> labels; ///< of label volumes; empty: all values above 0
  Frame frame = Frame::lps;  ///< of surfaces whose file names none
  ComparisonOptions options;
  std::vector<Requirement> requirements;
  std::optional<std::filesystem::path> json;
  std::optional<std::filesystem::path> distance; ///< A with its distances by vertex, .vtp
  int threads = 0;                               ///< 0: all that are available
};

/// What was read as A or B.
struct ComparedFile {
  std::filesystem::path path;
  Shape shape;
  Frame frame = Frame::lps; ///< of a surface; what is written goes back into it
  bool frame_is_assumed = false;
  std::vector<std::string> warnings;
};

struct ComparedFiles {
  CompareSettings settings;
  ComparedFile a;
  ComparedFile b;
  Comparison comparison;
};

/// A surface by its extension, or else a label volume. Throws InputError, which names the file.
ComparedFile read_compared_file(const std::filesystem::path &path, const CompareSettings &settings);

/// Reads, measures and writes what the settings ask for. Calls publish before the files appear, so that they do not
/// where it throws. Requirements are for the caller to check. Throws UsageError, InputError, OutputError, Cancelled.
ComparedFiles compare_files(const CompareSettings &settings, const Progress &progress,
                            const std::function<void(const ComparedFiles &)> &publish);

} // namespace volsurf
