#include "volsurf/io/output_file.h"

#include "volsurf/core/error.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <unistd.h>

namespace fs = std::filesystem;

namespace volsurf {

namespace {

[[noreturn]] void fail(const fs::path &path, const std::string &what, int error)
{
  throw OutputError(path.string() + ": " + what + ": " + std::strerror(error));
}

fs::path folder_of(const fs::path &file)
{
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Also where the link's own target does not exist yet.
fs::path follow_links(const fs::path &target)
{
  constexpr int kMostLinks = 40;
  fs::path destination = target;
  std::error_code error;
  for (int i = 0; fs::is_symlink(destination, error); ++i) {
    if (i == kMostLinks)
      throw OutputError(target.string() + ": the link leads to itself");
    destination = destination.parent_path() / fs::read_symlink(destination); // "/" keeps an absolute path as it is
  }
  return destination;
}

void check_destination(const fs::path &target, const fs::path &destination)
{
  std::error_code error;
  const fs::path folder = folder_of(destination);
  if (!fs::exists(folder, error))
    throw OutputError(target.string() + ": the folder " + folder.string() + " does not exist");
  if (!fs::is_directory(folder, error))
    throw OutputError(target.string() + ": " + folder.string() + " is not a folder");
  const fs::file_status status = fs::status(destination, error);
  if (!fs::status_known(status))
    fail(target, "the name cannot be used", error.value());
  if (!fs::exists(status))
    return;
  if (!fs::is_regular_file(status))
    throw OutputError(target.string() + ": found " + (fs::is_directory(status) ? "a folder" : "a device or pipe") +
                      "; allowed: a regular file or a new name");
  if (access(destination.c_str(), W_OK) != 0)
    fail(target, "the file cannot be replaced", errno);
}

/// A new empty file, open to the permissions that the user's umask leaves, unlike mkstemp's.
fs::path create_temporary(const fs::path &target, const fs::path &destination)
{
  for (int number = 0;; ++number) {
    const std::string name = ".volsurf-" + std::to_string(getpid()) + "-" + std::to_string(number);
    fs::path file = folder_of(destination) / (name + destination.extension().string());
    const int descriptor = open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (descriptor >= 0) {
      close(descriptor);
      return file;
    }
    if (errno != EEXIST)
      fail(target, "the folder " + folder_of(destination).string() + " cannot be written to", errno);
  }
}

/// Delayed write errors (quota, network, full disk) show here at the latest.
void flush_to_disk(const fs::path &target, const fs::path &file)
{
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    fail(target, "cannot be written", errno);
  const int error = fsync(descriptor) == 0 ? 0 : errno;
  close(descriptor);
  if (error != 0)
    fail(target, "cannot be written", error);
}

} // namespace

PendingOutput::PendingOutput(const fs::path &target) : target_(target), destination_(follow_links(target))
{
  if (!destination_.has_filename())
    throw OutputError(target.string() + ": found a folder's name; allowed: a file's name");
  check_destination(target_, destination_);
  temporary_ = create_temporary(target_, destination_);
}

PendingOutput::PendingOutput(PendingOutput &&other) noexcept
    : target_(std::move(other.target_)), destination_(std::move(other.destination_)),
      temporary_(std::move(other.temporary_))
{
  other.temporary_.clear();
}

PendingOutput::~PendingOutput()
{
  if (!temporary_.empty())
    unlink(temporary_.c_str());
}

void PendingOutput::write(const std::function<void(const fs::path &)> &writer) const
{
  try {
    writer(temporary_);
  } catch (const OutputError &error) {
    std::string message = error.what();
    const auto at = message.find(temporary_.string());
    if (at != std::string::npos)
      message.replace(at, temporary_.string().size(), target_.string());
    throw OutputError(message);
  }
}

void PendingOutput::commit()
{
  flush_to_disk(target_, temporary_);
  if (rename(temporary_.c_str(), destination_.c_str()) != 0)
    fail(target_, "cannot be put into place", errno);
  temporary_.clear();
}

void require_extension(const fs::path &path, const std::string &extension)
{
  const std::string found = path.extension().string();
  if (found != extension)
    throw UsageError(path.string() + ": found " + (found.empty() ? "no extension" : "the extension " + found) +
                     "; allowed: " + extension);
}

void write_bytes(const std::string &bytes, const fs::path &path)
{
  std::ofstream file(path, std::ios::binary);
  file << bytes << std::flush;
  if (!file)
    throw OutputError(path.string() + ": it could not be written; is the disk full?");
}

} // namespace volsurf
