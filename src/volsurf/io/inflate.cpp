#include "volsurf/io/inflate.h"

#include "volsurf/core/error.h"

#include <fstream>
#include <memory>
#include <vector>
#include <zlib.h>

namespace volsurf {

namespace {

constexpr std::size_t kBlockBytes = std::size_t{1} << 17;
constexpr int kGzipOrZlib = 32 + MAX_WBITS;

class Inflater {
public:
  explicit Inflater(const std::filesystem::path &file) : file_(file), out_(kBlockBytes)
  {
    if (inflateInit2(&stream_, kGzipOrZlib) != Z_OK)
      throw Error("zlib cannot be initialised");
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater &) = delete;
  Inflater &operator=(const Inflater &) = delete;

  std::uint64_t bytes() const { return bytes_; }
  bool complete() const { return state_ == State::between_members || state_ == State::after_the_end; }

  void consume(std::vector<char> &block, std::size_t count)
  {
    stream_.next_in = reinterpret_cast<Bytef *>(block.data());
    stream_.avail_in = static_cast<uInt>(count);
    while (stream_.avail_in > 0 && state_ != State::after_the_end)
      step();
  }

private:
  enum class State { before_the_first, inside, between_members, after_the_end };

  void step()
  {
    const bool may_be_padding = state_ == State::between_members;
    stream_.next_out = out_.data();
    stream_.avail_out = static_cast<uInt>(out_.size());
    const int result = inflate(&stream_, Z_NO_FLUSH);
    bytes_ += out_.size() - stream_.avail_out;
    if (result == Z_STREAM_END) {
      inflateReset(&stream_);
      state_ = State::between_members;
    } else if (result == Z_OK) {
      state_ = State::inside;
    } else if (may_be_padding) {
      state_ = State::after_the_end;
    } else {
      throw InputError(file_.string() + ": found damaged compressed data" +
                       (stream_.msg != nullptr ? std::string(" (") + stream_.msg + ")" : "") +
                       "; allowed: an intact file");
    }
  }

  const std::filesystem::path &file_;
  z_stream stream_{};
  std::vector<Bytef> out_;
  std::uint64_t bytes_ = 0;
  State state_ = State::before_the_first;
};

} // namespace

std::uint64_t inflated_size(const std::filesystem::path &file, std::uint64_t offset)
{
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(offset));
  Inflater inflater(file);
  std::vector<char> block(kBlockBytes);
  while (stream) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    inflater.consume(block, static_cast<std::size_t>(stream.gcount()));
  }
  if (!inflater.complete())
    throw InputError(file.string() + ": found compressed data that end too soon, after " +
                     std::to_string(inflater.bytes()) + " unpacked bytes; allowed: a complete file");
  return inflater.bytes();
}

std::string inflated_start(const std::filesystem::path &file, std::size_t count)
{
  const std::unique_ptr<gzFile_s, decltype(&gzclose)> stream(gzopen(file.c_str(), "rb"), &gzclose);
  if (!stream)
    throw InputError(file.string() + ": cannot be opened");
  std::string bytes(count, '\0');
  const int read = gzread(stream.get(), bytes.data(), static_cast<unsigned int>(count));
  if (read < 0)
    throw InputError(file.string() + ": found damaged compressed data; allowed: an intact file");
  bytes.resize(static_cast<std::size_t>(read));
  return bytes;
}

} // namespace volsurf
