#include "volsurf/io/sha256.h"

#include "volsurf/core/error.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <openssl/evp.h>

namespace volsurf {

namespace {

constexpr std::size_t kBlockBytes = std::size_t{1} << 18;

void check(int success)
{
  if (success != 1)
    throw Error("SHA-256 is not available in this build of libcrypto");
}

EVP_MD_CTX *context_of(void *context)
{
  return static_cast<EVP_MD_CTX *>(context);
}

std::uintmax_t add_file(Sha256 &sha256, const std::filesystem::path &file)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw InputError(file.string() + ": cannot be opened: " + std::strerror(errno));
  std::vector<char> block(kBlockBytes);
  std::uintmax_t bytes = 0;
  while (stream) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    const auto count = static_cast<std::size_t>(stream.gcount());
    sha256.add(block.data(), count);
    bytes += count;
  }
  if (stream.bad())
    throw InputError(file.string() + ": cannot be read to its end");
  return bytes;
}

std::string hexadecimal(const Sha256::Digest &digest)
{
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

} // namespace

Sha256::Sha256() : context_(EVP_MD_CTX_new())
{
  check(EVP_DigestInit_ex(context_of(context_.get()), EVP_sha256(), nullptr));
}

void Sha256::Free::operator()(void *context) const
{
  EVP_MD_CTX_free(context_of(context));
}

void Sha256::add(const void *bytes, std::size_t count)
{
  check(EVP_DigestUpdate(context_of(context_.get()), bytes, count));
}

Sha256::Digest Sha256::digest()
{
  Digest digest{};
  check(EVP_DigestFinal_ex(context_of(context_.get()), digest.data(), nullptr));
  return digest;
}

FileDigest sha256_of_files(const std::vector<std::filesystem::path> &files)
{
  Sha256 sha256;
  FileDigest result;
  for (const std::filesystem::path &file : files)
    result.bytes += add_file(sha256, file);
  result.sha256 = hexadecimal(sha256.digest());
  return result;
}

} // namespace volsurf
