// SHA-256 of bytes and of files, streamed.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace volsurf {

/// The digest of bytes that come in pieces.
class Sha256 {
public:
  using Digest = std::array<std::uint8_t, 32>;

  Sha256();
  void add(const void *bytes, std::size_t count);

  /// Of all that was added. Called once, last.
  Digest digest();

private:
  struct Free {
    void operator()(void *context) const;
  };
  std::unique_ptr<void, Free> context_;
};

struct FileDigest {
  std::uintmax_t bytes = 0; ///< of all files together
  std::string sha256;       ///< 64 lower-case hexadecimal digits
};

/// The digest of the files' bytes, one file after the other. Throws InputError where one cannot be read.
FileDigest sha256_of_files(const std::vector<std::filesystem::path> &files);

} // namespace volsurf
