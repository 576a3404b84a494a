#include "volsurf/io/array_file_layout.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"
#include "volsurf/io/sha256.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <zlib.h>

namespace volsurf {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kFastest = 1;
constexpr std::int64_t kBlocksAtOnce = 64;

/// A file and the digest of what has been written to it.
class DigestedFile {
public:
  explicit DigestedFile(const std::filesystem::path &path) : path_(path), stream_(path, std::ios::binary) {}

  void write(const void *bytes, std::size_t count)
  {
    sha256_.add(bytes, count);
    put(bytes, count);
  }

  void finish()
  {
    const Sha256::Digest digest = sha256_.digest();
    put(digest.data(), digest.size());
    stream_.flush();
    check();
  }

private:
  void put(const void *bytes, std::size_t count)
  {
    stream_.write(static_cast<const char *>(bytes), static_cast<std::streamsize>(count));
    check();
  }

  void check() const
  {
    if (!stream_)
      throw OutputError(path_.string() + ": it could not be written; is the disk full?");
  }

  const std::filesystem::path &path_;
  std::ofstream stream_;
  Sha256 sha256_;
};

std::string header_of(const std::string &facts, const std::vector<NamedArray> &arrays)
{
  Json list = Json::array();
  for (const NamedArray &array : arrays)
    list.push_back({{"name", array.name}, {"type", kind_of(array.type).name}, {"count", array.count}});
  return Json{{"facts", Json::parse(facts)}, {"arrays", list}}.dump() + "\n";
}

using Bytes = std::vector<Bytef>;

Bytes deflated(const Bytef *bytes, std::uint64_t count)
{
  uLongf size = compressBound(count);
  Bytes packed(size);
  if (compress2(packed.data(), &size, bytes, count, kFastest) != Z_OK)
    throw Error("zlib cannot pack a block");
  packed.resize(size);
  return packed;
}

/// Blocks are packed some at a time, so that a large array needs little memory beside its own.
void write_blocks(const NamedArray &array, DigestedFile &file)
{
  const auto *const begin = static_cast<const Bytef *>(array.data);
  const auto bytes = static_cast<std::uint64_t>(array.count) * static_cast<std::uint64_t>(kind_of(array.type).bytes);
  const auto blocks = static_cast<std::int64_t>((bytes + kBlockBytes - 1) / kBlockBytes);
  for (std::int64_t first = 0; first < blocks; first += kBlocksAtOnce) {
    std::vector<Bytes> packed(static_cast<std::size_t>(std::min(kBlocksAtOnce, blocks - first)));
    parallel_for_slabs(static_cast<std::int64_t>(packed.size()), 1, [&](const Slab &slab) {
      const std::uint64_t offset = static_cast<std::uint64_t>(first + slab.index) * kBlockBytes;
      packed[static_cast<std::size_t>(slab.index)] = deflated(begin + offset, std::min(kBlockBytes, bytes - offset));
    });
    for (const Bytes &block : packed) {
      const auto size = static_cast<StoredSize>(block.size());
      file.write(&size, sizeof(size));
      file.write(block.data(), block.size());
    }
  }
}

} // namespace

void write_array_file(const std::filesystem::path &path, const ArrayFileKind &kind, const std::string &facts,
                      const std::vector<NamedArray> &arrays)
{
  DigestedFile file(path);
  const std::string start = first_line_of(kind) + header_of(facts, arrays);
  file.write(start.data(), start.size());
  for (const NamedArray &array : arrays)
    write_blocks(array, file);
  file.finish();
}

} // namespace volsurf
