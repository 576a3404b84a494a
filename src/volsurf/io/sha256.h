// SHA-256 of files, streamed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace volsurf {

struct FileDigest {
  std::uintmax_t bytes = 0; ///< of all files together
  std::string sha256;       ///< 64 lower-case hexadecimal digits
};

/// The digest of the files' bytes, one file after the other. Throws InputError where one cannot be read.
FileDigest sha256_of_files(const std::vector<std::filesystem::path> &files);

} // namespace volsurf
