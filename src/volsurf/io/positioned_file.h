// A file that several threads read at places of their own.
#pragma once

#include <cstdint>
#include <filesystem>

namespace volsurf {

class PositionedFile {
public:
  /// Throws InputError.
  explicit PositionedFile(const std::filesystem::path &path);
  ~PositionedFile();
  PositionedFile(const PositionedFile &) = delete;
  PositionedFile &operator=(const PositionedFile &) = delete;

  const std::filesystem::path &path() const { return path_; }
  std::uint64_t size() const { return size_; }

  /// Reads `count` bytes from `offset` on. Thread-safe. Throws InputError where there are not as many.
  void read(std::uint64_t offset, void *out, std::size_t count) const;

private:
  std::filesystem::path path_;
  int descriptor_;
  std::uint64_t size_ = 0;
};

} // namespace volsurf
