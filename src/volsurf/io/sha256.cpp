#include "volsurf/io/sha256.h"

#include "volsurf/core/error.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <openssl/evp.h>

namespace volsurf {

namespace {

constexpr std::size_t kBlockBytes = std::size_t{1} << 18;

using DigestContext = std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)>;

void check(int success)
{
  if (success != 1)
    throw Error("SHA-256 is not available in this build of libcrypto");
}

std::uintmax_t add_file(EVP_MD_CTX *context, const std::filesystem::path &file)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw InputError(file.string() + ": cannot be opened: " + std::strerror(errno));
  std::vector<char> block(kBlockBytes);
  std::uintmax_t bytes = 0;
  while (stream) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    const auto count = static_cast<std::size_t>(stream.gcount());
    check(EVP_DigestUpdate(context, block.data(), count));
    bytes += count;
  }
  if (stream.bad())
    throw InputError(file.string() + ": cannot be read to its end");
  return bytes;
}

std::string hexadecimal(const unsigned char *bytes, unsigned int count)
{
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < count; ++i) {
    text += kDigits[bytes[i] >> 4];
    text += kDigits[bytes[i] & 15];
  }
  return text;
}

} // namespace

FileDigest sha256_of_files(const std::vector<std::filesystem::path> &files)
{
  const DigestContext context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  check(EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr));
  FileDigest digest;
  for (const std::filesystem::path &file : files)
    digest.bytes += add_file(context.get(), file);
  std::array<unsigned char, EVP_MAX_MD_SIZE> value{};
  unsigned int size = 0;
  check(EVP_DigestFinal_ex(context.get(), value.data(), &size));
  digest.sha256 = hexadecimal(value.data(), size);
  return digest;
}

} // namespace volsurf
