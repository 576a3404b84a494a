#include "volsurf/io/positioned_file.h"

#include "volsurf/core/error.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace volsurf {

PositionedFile::PositionedFile(const std::filesystem::path &path)
    : path_(path), descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC))
{
  const off_t end = descriptor_ < 0 ? -1 : lseek(descriptor_, 0, SEEK_END);
  if (end < 0) {
    const int error = errno;
    if (descriptor_ >= 0)
      close(descriptor_);
    throw InputError(path.string() + ": cannot be opened: " + std::strerror(error));
  }
  size_ = static_cast<std::uint64_t>(end);
}

PositionedFile::~PositionedFile()
{
  close(descriptor_);
}

void PositionedFile::read(std::uint64_t offset, void *out, std::size_t count) const
{
  auto *next = static_cast<char *>(out);
  while (count > 0) {
    const ssize_t got = pread(descriptor_, next, count, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR)
      continue;
    if (got <= 0)
      throw InputError(path_.string() + ": cannot be read to its end" +
                       (got < 0 ? std::string(": ") + std::strerror(errno) : std::string()));
    next += got;
    offset += static_cast<std::uint64_t>(got);
    count -= static_cast<std::size_t>(got);
  }
}

} // namespace volsurf
