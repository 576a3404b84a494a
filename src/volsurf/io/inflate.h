// The size of compressed data, without keeping it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace volsurf {

/// Unpacks a file's gzip members (or one zlib stream) from byte `offset` to the end, checks their checksums, and
/// returns the number of bytes that they hold. Bytes after the last stream are ignored. Throws InputError where a
/// stream is damaged or ends too soon.
std::uint64_t inflated_size(const std::filesystem::path &file, std::uint64_t offset);

/// The first `count` bytes of a file, unpacked if it is gzip compressed; fewer where it is shorter. Throws
/// InputError.
std::string inflated_start(const std::filesystem::path &file, std::size_t count);

} // namespace volsurf
