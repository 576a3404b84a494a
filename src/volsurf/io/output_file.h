// Output files appear whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace volsurf {

/// A result on its way to disk: write() to temporary_path(), then commit(). Without commit() nothing is left behind,
/// and a file that was there before stays as it was.
class PendingOutput {
public:
  /// Creates an empty temporary file beside the target, with the target's extension. A target that is a symbolic link
  /// is followed. Throws OutputError where the folder is missing or not writable, or the target is not a regular file
  /// or is read-only.
  explicit PendingOutput(const std::filesystem::path &target);

  /// Removes the temporary file unless it was committed.
  ~PendingOutput();

  PendingOutput(PendingOutput &&other) noexcept;
  PendingOutput &operator=(PendingOutput &&) = delete;
  PendingOutput(const PendingOutput &) = delete;
  PendingOutput &operator=(const PendingOutput &) = delete;

  /// The path that the user asked for.
  const std::filesystem::path &target() const { return target_; }
  const std::filesystem::path &temporary_path() const { return temporary_; }

  /// Calls `writer` with the temporary path. Its OutputErrors then name the target, which the user knows.
  void write(const std::function<void(const std::filesystem::path &)> &writer) const;

  /// Forces the bytes to disk and renames the file to the target. Throws OutputError.
  void commit();

private:
  std::filesystem::path target_;
  std::filesystem::path destination_; ///< the target after following links
  std::filesystem::path temporary_;   ///< empty once committed or moved from
};

/// Throws UsageError unless a file's name has this extension, the one of its format.
void require_extension(const std::filesystem::path &path, const std::string &extension);

/// Writes a whole file. Throws OutputError.
void write_bytes(const std::string &bytes, const std::filesystem::path &path);

} // namespace volsurf
