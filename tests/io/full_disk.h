// The law of every writer: on a disk of any size it either throws OutputError or leaves the whole file.
#pragma once

#include "support/temporary_folder.h"
#include "volsurf/core/error.h"

#include <gtest/gtest.h>

namespace volsurf::test {

/// `write(path)` must write a file of 1 to 120 pages.
template <typename Write> void expect_full_disk_is_noticed(const std::string &name, const Write &write)
{
  TemporaryFolder elsewhere;
  write(elsewhere / name);
  const std::string whole = read_file(elsewhere / name);
  const int pages_needed = static_cast<int>((whole.size() + 4095) / 4096);
  ASSERT_LE(pages_needed, 120);
  const int pages = 128;
  SmallDisk disk(pages);
  if (!disk.mounted())
    GTEST_SKIP() << "no tmpfs can be mounted here (needs root)";
  for (int free_pages = 0; free_pages <= pages_needed; ++free_pages) {
    write_file(disk / "filler", std::string(static_cast<std::size_t>(pages - 1 - free_pages) * 4096, 'x'));
    if (std::filesystem::space(disk.path()).available < static_cast<std::uintmax_t>(free_pages) * 4096)
      continue;
    bool thrown = false;
    try {
      write(disk / name);
    } catch (const OutputError &) {
      thrown = true;
    }
    if (!thrown) {
      EXPECT_EQ(read_file(disk / name), whole) << "with " << free_pages << " of " << pages_needed << " pages free";
    }
    std::filesystem::remove(disk / name);
  }
  std::filesystem::remove(disk / "filler");
  EXPECT_NO_THROW(write(disk / name));
}

} // namespace volsurf::test
