// Folders and disks that vanish with the test.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <sys/mount.h>

namespace volsurf::test {

class TemporaryFolder {
public:
  TemporaryFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "volsurf-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &operator=(const TemporaryFolder &) = delete;

  std::filesystem::path operator/(const std::string &name) const { return path_ / name; }
  const std::filesystem::path &path() const { return path_; }

private:
  std::filesystem::path path_;
};

/// A disk in memory of `pages` pages of 4096 bytes. Only where the test may mount one; see mounted().
class SmallDisk {
public:
  explicit SmallDisk(int pages)
  {
    const std::string options = "size=" + std::to_string(pages * 4096);
    mounted_ = mount("tmpfs", folder_.path().c_str(), "tmpfs", 0, options.c_str()) == 0;
  }
  ~SmallDisk()
  {
    if (mounted_)
      umount2(folder_.path().c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk &) = delete;
  SmallDisk &operator=(const SmallDisk &) = delete;

  bool mounted() const { return mounted_; }
  bool make_read_only() const
  {
    return mount("tmpfs", folder_.path().c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) == 0;
  }
  const std::filesystem::path &path() const { return folder_.path(); }
  std::filesystem::path operator/(const std::string &name) const { return folder_ / name; }

private:
  TemporaryFolder folder_;
  bool mounted_ = false;
};

inline void write_file(const std::filesystem::path &path, const std::string &bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

inline std::string read_file(const std::filesystem::path &path)
{
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::ptrdiff_t file_count(const std::filesystem::path &folder)
{
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

} // namespace volsurf::test
