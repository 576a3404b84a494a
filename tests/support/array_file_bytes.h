// Array files by hand: any first line, header and blocks under a checksum that is right.
#pragma once

#include "volsurf/io/sha256.h"

#include <cstdint>
#include <string>

namespace volsurf::test {

/// The bytes with their SHA-256 behind them.
inline std::string with_checksum(const std::string &bytes)
{
  Sha256 sha256;
  sha256.add(bytes.data(), bytes.size());
  const Sha256::Digest digest = sha256.digest();
  return bytes + std::string(digest.begin(), digest.end());
}

inline std::string without_checksum(const std::string &file)
{
  return file.substr(0, file.size() - sizeof(Sha256::Digest));
}

/// Replaces the first occurrence of a part, which must be there.
inline std::string replaced(std::string text, const std::string &part, const std::string &by)
{
  return text.replace(text.find(part), part.size(), by);
}

} // namespace volsurf::test
