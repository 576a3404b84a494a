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

using Json = nlohmann::json;

constexpr std::size_t kDigestBytes = sizeof(Sha256::Digest);
constexpr std::size_t kLongestFirstLine = 64;
constexpr std::size_t kLongestHeader = std::size_t{1} << 20;
constexpr std::uint64_t kBestRatio = 1032; // deflate can do no better
constexpr std::int64_t kMostElements = std::int64_t{1} << 48;

const ElementKind *kind_named(const std::string &name)
{
  const auto *const found = std::find_if(kElementKinds.begin(), kElementKinds.end(),
                                         [&](const ElementKind &kind) { return kind.name == name; });
  return found == kElementKinds.end() ? nullptr : found;
}

} // namespace

bool is_array_file(const std::filesystem::path &path, const ArrayFileKind &kind)
{
  const std::string wanted = std::string(kind.name) + " ";
  std::string start(wanted.size(), '\0');
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    return false;
  std::ifstream(path, std::ios::binary).read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == wanted;
}

ArrayFile::ArrayFile(const std::filesystem::path &path, const ArrayFileKind &kind) : file_(path)
{
  check_kind(kind);
  check_digest();
  read_header(first_line_of(kind).size());
}

void ArrayFile::fail(const std::string &found) const
{
  throw InputError(file_.path().string() + ": found " + found);
}

void ArrayFile::check_kind(const ArrayFileKind &kind) const
{
  const std::string wanted = first_line_of(kind);
  const std::string found = read_line(0, kLongestFirstLine);
  if (found.rfind(std::string(kind.name) + " ", 0) != 0)
    fail("no " + std::string(kind.name) + " in it; allowed: a file that begins with one");
  if (found != wanted)
    fail("\"" + found.substr(0, found.size() - 1) + "\", a version that this program does not know; allowed: \"" +
         wanted.substr(0, wanted.size() - 1) + "\"");
}

void ArrayFile::check_digest()
{
  if (file_.size() < kDigestBytes)
    fail("a file that ends too soon; allowed: a complete one");
  end_ = file_.size() - kDigestBytes;
  Sha256 sha256;
  std::vector<char> block(static_cast<std::size_t>(std::min(kBlockBytes, end_)));
  for (std::uint64_t offset = 0; offset < end_; offset += kBlockBytes) {
    const auto count = static_cast<std::size_t>(std::min(kBlockBytes, end_ - offset));
    file_.read(offset, block.data(), count);
    sha256.add(block.data(), count);
  }
  Sha256::Digest stored{};
  file_.read(end_, stored.data(), stored.size());
  if (sha256.digest() != stored)
    fail("bytes that do not match their checksum: the file is damaged or incomplete; allowed: an intact one");
}

std::string ArrayFile::read_line(std::uint64_t begin, std::size_t longest) const
{
  std::string line(static_cast<std::size_t>(std::min<std::uint64_t>(longest, file_.size() - begin)), '\0');
  file_.read(begin, line.data(), line.size());
  const auto end = line.find('\n');
  if (end == std::string::npos)
    fail("no line that ends, at byte " + std::to_string(begin) + "; allowed: an intact file");
  line.resize(end + 1);
  return line;
}

void ArrayFile::read_header(std::uint64_t begin)
{
  const std::string line = read_line(begin, kLongestHeader);
  std::uint64_t offset = begin + line.size();
  try {
    const Json header = Json::parse(line);
    facts_ = header.at("facts").dump();
    for (const Json &entry : header.at("arrays")) {
      const ElementKind *const kind = kind_named(entry.at("type").get<std::string>());
      const auto count = entry.at("count").is_number_integer() ? entry["count"].get<std::int64_t>() : -1;
      if (kind == nullptr || count < 0 || count > kMostElements)
        fail("an array of an unknown type or length in its header");
      const auto bytes = static_cast<std::uint64_t>(count) * static_cast<std::uint64_t>(kind->bytes);
      arrays_[entry.at("name").get<std::string>()] = {kind->type, count, find_blocks(bytes, offset)};
    }
  } catch (const Json::exception &error) {
    fail(std::string("a header that cannot be understood: ") + error.what());
  }
  if (offset != end_)
    fail("bytes that belong to no array");
}

std::vector<ArrayFile::Block> ArrayFile::find_blocks(std::uint64_t bytes, std::uint64_t &offset) const
{
  std::vector<Block> blocks;
  for (std::uint64_t done = 0; done < bytes; done += kBlockBytes) {
    Block block{offset + sizeof(StoredSize), 0};
    if (block.offset > end_)
      fail("an array that its file has no room for");
    file_.read(offset, &block.stored_bytes, sizeof(StoredSize));
    const std::uint64_t raw_bytes = std::min(kBlockBytes, bytes - done);
    offset = block.offset + block.stored_bytes;
    if (offset > end_ || block.stored_bytes < raw_bytes / kBestRatio || block.stored_bytes > compressBound(raw_bytes))
      fail("a block of an array that cannot be as long as it says");
    blocks.push_back(block);
  }
  return blocks;
}

const ArrayFile::Array &ArrayFile::array(const std::string &name) const
{
  const auto found = arrays_.find(name);
  if (found == arrays_.end())
    fail("no array \"" + name + "\"");
  return found->second;
}

void ArrayFile::read_elements(const std::string &name, ElementType type, void *out, std::int64_t count) const
{
  const Array &wanted = array(name);
  if (wanted.type != type || wanted.count != count)
    fail("an array \"" + name + "\" of " + std::to_string(wanted.count) + " " + kind_of(wanted.type).name +
         "; allowed here: " + std::to_string(count) + " " + kind_of(type).name);
  const auto bytes = static_cast<std::uint64_t>(count) * static_cast<std::uint64_t>(kind_of(type).bytes);
  parallel_for_slabs(static_cast<std::int64_t>(wanted.blocks.size()), 1, [&](const Slab &slab) {
    const std::uint64_t begin = static_cast<std::uint64_t>(slab.index) * kBlockBytes;
    inflate_block(wanted.blocks[static_cast<std::size_t>(slab.index)], static_cast<char *>(out) + begin,
                  std::min(kBlockBytes, bytes - begin));
  });
}

void ArrayFile::inflate_block(const Block &block, void *out, std::uint64_t bytes) const
{
  std::vector<Bytef> stored(block.stored_bytes);
  file_.read(block.offset, stored.data(), stored.size());
  uLongf size = bytes;
  if (uncompress(static_cast<Bytef *>(out), &size, stored.data(), stored.size()) != Z_OK || size != bytes)
    fail("a block of an array that cannot be unpacked to what it should hold");
}

} // namespace volsurf
